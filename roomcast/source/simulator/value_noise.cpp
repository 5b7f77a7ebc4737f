// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulator/value_noise.h"

#include <algorithm>
#include <cmath>

namespace roomcast::sim {
namespace {

float lattice_value(int x, int y, std::uint32_t seed) {
  const auto hash =
      hash_of(hash_of(seed, static_cast<std::uint32_t>(x)), static_cast<std::uint32_t>(y));
  return 2.0F * unit_from_hash(hash) - 1.0F;
}

float smooth(float t) { return t * t * (3.0F - 2.0F * t); }

}  // namespace

float value_noise(const Eigen::Vector2f& at, std::uint32_t seed) {
  const float x = std::floor(at.x());
  const float y = std::floor(at.y());
  const float sx = smooth(at.x() - x);
  const float sy = smooth(at.y() - y);
  const int ix = static_cast<int>(x);
  const int iy = static_cast<int>(y);
  const float top = std::lerp(lattice_value(ix, iy, seed), lattice_value(ix + 1, iy, seed), sx);
  const float bottom =
      std::lerp(lattice_value(ix, iy + 1, seed), lattice_value(ix + 1, iy + 1, seed), sx);
  return std::lerp(top, bottom, sy);
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

}  // namespace roomcast::sim
