// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/random/gaussian_table.h"

#include <cmath>
#include <numbers>

#include "roomcast/simulator/random/value_noise.h"

namespace roomcast::simulator {
namespace {

/// Quantile of the normal distribution with upper tail `tail`, by Newton's method from `start`.
double upper_quantile(double tail, double start) {
  constexpr int kSteps = 6;
  double x = start;
  for (int i = 0; i < kSteps; ++i) {
    const double too_much = 0.5 * std::erfc(x / std::numbers::sqrt2) - tail;
    const double density =
        std::exp(-0.5 * x * x) * 0.5 * std::numbers::inv_sqrtpi * std::numbers::sqrt2;
    x += too_much / density;
  }
  return x;
}

}  // namespace

GaussianTable::GaussianTable() : quantiles_(kSize), shuffled_(kSize + kRun) {
  double quantile = 0.0;
  for (std::size_t i = kSize / 2; i < kSize; ++i) {  // from the median up; other half mirrored
    quantile = upper_quantile((static_cast<double>(kSize - i) - 0.5) / kSize, quantile);
    quantiles_[i] = static_cast<float>(quantile);
    quantiles_[kSize - 1 - i] = static_cast<float>(-quantile);
  }
  for (std::size_t i = 0; i < shuffled_.size(); ++i) {
    const float value = of_hash(mix_bits(static_cast<std::uint32_t>(i) + 1U));
    shuffled_[i] = static_cast<std::int8_t>(std::lround(kRunScale * value));
  }
}

}  // namespace roomcast::simulator
