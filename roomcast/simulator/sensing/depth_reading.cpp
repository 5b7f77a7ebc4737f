// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/depth_reading.h"

#include <algorithm>
#include <cmath>

namespace roomcast::simulator {

float signal_strength(float infrared, float facing, float z_m) {
  return infrared * facing / std::max(z_m * z_m, 1e-6F);
}

bool is_depth_step(float a_m, float b_m) {
  return std::abs(a_m - b_m) > 0.02F + 0.03F * std::min(a_m, b_m);
}

OtherSurface other_surface(const DepthReading& centre, const std::array<FineSample, 4>& samples) {
  float count = 0.0F, strength = 0.0F, weighted_z = 0.0F;
  for (const FineSample& sample : samples) {
    if (sample.z_m <= 0.0F || !is_depth_step(centre.z_m, sample.z_m)) continue;
    const float weight = std::max(sample.strength, 1e-6F);
    count += 1.0F;
    strength += weight;
    weighted_z += weight * sample.z_m;
  }
  if (count == 0.0F) return {};
  const float here = std::max(signal_strength(centre.infrared, centre.facing, centre.z_m), 1e-6F);
  return {count / static_cast<float>(samples.size()), weighted_z / strength,
          strength / count / here};
}

}  // namespace roomcast::simulator
