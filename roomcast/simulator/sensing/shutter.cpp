// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/shutter.h"

#include <algorithm>
#include <cmath>

#include "roomcast/core/assert.h"
#include "roomcast/core/srgb.h"

namespace roomcast::simulator {
namespace {

constexpr float kSlices = static_cast<float>(kShutterInstants);

using Weights = std::array<float, kShutterInstants>;

/// One channel of one pixel, blended over the instants.
template <class Channel>
std::uint8_t blended(const Weights& weights, const Channel& level_at) {
  static const std::array<float, 256> linear = linear_levels();
  float light = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) light += weights[i] * linear[level_at(i)];
  return static_cast<std::uint8_t>(level_from_linear(std::min(light, 1.0F)) + 0.5F);
}

bool same(const Rgb8& a, const Rgb8& b) {
  return a.r == b.r && a.g == b.g && a.b == b.b;
}

}  // namespace

std::array<nanoseconds, kShutterInstants> Shutter::instants() const {
  const double slice_s = static_cast<double>(readout_s + exposure_s) / kShutterInstants;
  std::array<nanoseconds, kShutterInstants> all{};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double slices = static_cast<double>(i) + 0.5 - 0.5 * kShutterInstants;
    all[i] = nanoseconds(std::llround(1e9 * slice_s * slices));
  }
  return all;
}

std::array<float, kShutterInstants> Shutter::weights(float share_of_height) const {
  const float slice_s = (readout_s + exposure_s) / kSlices;
  const float opens_s = share_of_height * readout_s;
  const float closes_s = opens_s + std::max(exposure_s, 1e-4F);
  Weights all{};
  float sum = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const float begin_s = slice_s * static_cast<float>(i);
    const float end_s = begin_s + slice_s;
    all[i] = std::max(0.0F, std::min(end_s, closes_s) - std::max(begin_s, opens_s));
    sum += all[i];
  }
  for (float& weight : all) weight /= sum;
  return all;
}

void expose_rows(const Shutter& shutter, std::span<const ColorImage, kShutterInstants> lights,
                 ImageView<Rgb8> out) {
  for (const ColorImage& light : lights) ROOMCAST_ASSERT(same_size(light.view(), out));
  for (int y = 0; y < out.height; ++y) {
    const float share = (static_cast<float>(y) + 0.5F) / static_cast<float>(out.height);
    const Weights weights = shutter.weights(share);
    for (int x = 0; x < out.width; ++x) {
      const Rgb8 first = lights[0].at(x, y);
      const bool rests =
          std::all_of(lights.begin() + 1, lights.end(),
                      [&](const ColorImage& light) { return same(light.at(x, y), first); });
      if (rests) {
        out.at(x, y) = first;
        continue;
      }
      out.at(x, y) = {blended(weights, [&](std::size_t i) { return lights[i].at(x, y).r; }),
                      blended(weights, [&](std::size_t i) { return lights[i].at(x, y).g; }),
                      blended(weights, [&](std::size_t i) { return lights[i].at(x, y).b; })};
    }
  }
}

}  // namespace roomcast::simulator
