// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/noise_law.h"

namespace roomcast::simulator {

SensorProfile with_drawn_noise(SensorProfile profile, Random& random) {
  if (measures_disparity(profile.principle)) {
    profile.farthest_m = random.between(5.0F, 8.0F);
    profile.subpixel = random.between(0.04F, 0.09F);
    profile.bias_disparity_px = random.between(0.05F, 0.25F);
    return profile;
  }
  profile.farthest_m = random.between(4.5F, 6.5F);
  profile.amplitude_noise_mm = random.between(0.05F, 0.3F);
  profile.bias_wiggle_mm = random.between(4.0F, 15.0F);
  profile.bias_offset_mm = 10.0F;
  profile.bias_wave_mm = random.between(2.0F, 6.0F);
  return profile;
}

}  // namespace roomcast::simulator
