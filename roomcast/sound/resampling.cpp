// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sound/resampling.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace roomcast::sound {
namespace {

constexpr double kCrossings = 16;

double sinc(double x) {
  if (std::abs(x) < 1e-9) return 1;
  return std::sin(std::numbers::pi * x) / (std::numbers::pi * x);
}

/// Hann, from -1 to 1.
double window(double x) {
  return 0.5 + 0.5 * std::cos(std::numbers::pi * x);
}

/// `cutoff`: share of the source's half rate that passes.
float value_at(const std::vector<float>& samples, double place, double cutoff) {
  const double reach = kCrossings / cutoff;
  const auto first = std::max<std::int64_t>(0, std::llround(std::ceil(place - reach)));
  const auto last = std::min(static_cast<std::int64_t>(samples.size()) - 1,
                             std::int64_t{std::llround(std::floor(place + reach))});
  double sum = 0;
  for (std::int64_t i = first; i <= last; ++i) {
    const double away = static_cast<double>(i) - place;
    sum +=
        samples[static_cast<std::size_t>(i)] * cutoff * sinc(cutoff * away) * window(away / reach);
  }
  return static_cast<float>(sum);
}

}  // namespace

std::vector<float> resampled(std::vector<float> samples, int from_hz, int to_hz) {
  if (from_hz == to_hz) return samples;
  const double step = static_cast<double>(from_hz) / to_hz;
  const double cutoff = std::min(1.0, 1 / step);
  std::vector<float> out(
      static_cast<std::size_t>(std::llround(static_cast<double>(samples.size()) / step)));
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = value_at(samples, static_cast<double>(i) * step, cutoff);
  return out;
}

}  // namespace roomcast::sound
