// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/random/value_noise.h"

#include <algorithm>
#include <cmath>

namespace roomcast::simulator {
namespace {

float lattice_value(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
  return 2.0F * unit_from_hash(mix_bits(seed + 0x9e3779b1U * x + 0x85ebca77U * y)) - 1.0F;
}

/// Unlike std::lerp it does not handle infinities, which makes it several times cheaper.
float between(float a, float b, float share) {
  return a + (b - a) * share;
}

float fade(float t) {
  return t * t * (3.0F - 2.0F * t);
}

}  // namespace

float value_noise(const Eigen::Vector2f& at, std::uint32_t seed) {
  const float x = std::floor(at.x());
  const float y = std::floor(at.y());
  const float sx = fade(at.x() - x);
  const float sy = fade(at.y() - y);
  const auto ix = static_cast<std::uint32_t>(static_cast<int>(x));
  const auto iy = static_cast<std::uint32_t>(static_cast<int>(y));
  const auto mixed = mix_bits(seed + 1U);
  const float top = between(lattice_value(ix, iy, mixed), lattice_value(ix + 1, iy, mixed), sx);
  const float bottom =
      between(lattice_value(ix, iy + 1, mixed), lattice_value(ix + 1, iy + 1, mixed), sx);
  return between(top, bottom, sy);
}

float fractal_noise(const Eigen::Vector2f& at_m, float wavelength_m, int octaves, float footprint_m,
                    std::uint32_t seed) {
  float sum = 0.0F;
  float strength = 0.6F;
  for (int octave = 0; octave < octaves; ++octave) {
    const float visible = std::clamp(2.0F - 2.0F * footprint_m / wavelength_m, 0.0F, 1.0F);
    if (visible == 0.0F) break;
    const auto octave_seed = seed + static_cast<std::uint32_t>(octave) * 101U;
    sum += visible * strength * value_noise(at_m / wavelength_m, octave_seed);
    strength *= 0.5F;
    wavelength_m *= 0.5F;
  }
  return sum;
}

}  // namespace roomcast::simulator
