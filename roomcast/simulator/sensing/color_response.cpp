// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/color_response.h"

#include <algorithm>
#include <cmath>

#include "roomcast/core/assert.h"
#include "roomcast/core/srgb.h"
#include "roomcast/simulator/random/value_noise.h"

namespace roomcast::simulator {
namespace {

constexpr float kReadSigma = 0.0004F;   // share of full scale, linear
constexpr float kShotVariance = 7e-5F;  // per unit of signal
constexpr float kFine = 256.0F;         // steps per grey level

float slope_at_linear(float linear) {
  constexpr float kStep = 1e-3F;
  const float low = std::max(0.0F, linear - kStep), high = std::min(1.0F, linear + kStep);
  return (level_from_linear(high) - level_from_linear(low)) / (high - low);
}

}  // namespace

float ColorResponse::sigma_at_level(float level) {
  const float linear = linear_from_level(level);
  return slope_at_linear(linear) * std::sqrt(kReadSigma * kReadSigma + kShotVariance * linear);
}

ColorResponse::ColorResponse(const std::array<float, 3>& gain, bool noise) {
  for (std::size_t channel = 0; channel < 3; ++channel) {
    for (std::size_t level = 0; level < 256; ++level) {
      const float light = gain[channel] * linear_from_level(static_cast<float>(level));
      const float out = gain[channel] == 1.0F ? static_cast<float>(level)
                                              : level_from_linear(std::min(light, 1.0F));
      const float sigma = noise ? sigma_at_level(out) : 0.0F;
      levels_[channel][level] = {
          static_cast<std::int32_t>(std::lround(kFine * out)),
          static_cast<std::int32_t>(std::lround(kFine * sigma / GaussianTable::kRunScale))};
    }
  }
}

void ColorResponse::expose(ColorView light, std::uint32_t key, const GaussianTable& gaussians,
                           ImageView<Rgb8> out) const {
  ROOMCAST_ASSERT(same_size(light, out) &&
                  3U * static_cast<std::size_t>(light.width) <= GaussianTable::kRun);
  const auto& [red, green, blue] = levels_;
  const auto value = [](const Level& level, int noise) {
    return static_cast<std::uint8_t>(
        std::clamp((level.mean + level.sigma * noise + 128) >> 8, 0, 255));
  };
  for (int y = 0; y < light.height; ++y) {
    const std::int8_t* noise = gaussians.shuffled_run(hash_of(key, static_cast<std::uint32_t>(y)));
    const Rgb8* in = light.row(y);
    Rgb8* to = out.row(y);
    for (int x = 0; x < light.width; ++x, noise += 3) {
      to[x] = {value(red[in[x].r], noise[0]), value(green[in[x].g], noise[1]),
               value(blue[in[x].b], noise[2])};
    }
  }
}

float mean_brightness(ColorView picture) {
  double sum = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const Rgb8 pixel = picture.at(x, y);
      sum += static_cast<double>(0.2126F * linear_from_level(pixel.r) +
                                 0.7152F * linear_from_level(pixel.g) +
                                 0.0722F * linear_from_level(pixel.b));
    }
  }
  return static_cast<float>(sum / static_cast<double>(picture.pixel_count()));
}

}  // namespace roomcast::simulator
