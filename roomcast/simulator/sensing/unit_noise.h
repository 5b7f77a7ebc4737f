// SPDX-License-Identifier: Apache-2.0
// Unscaled random part of one depth frame: a picture of numbers with mean 0 and standard deviation
// 1. Time of flight: independent from pixel to pixel. Stereo: correlated over the matching window,
// because neighbouring pixels are matched with mostly the same data (window 4 px: ours). A function
// of (key, pixel).
#pragma once

#include <cstdint>

#include "roomcast/core/image.h"
#include "roomcast/simulator/random/gaussian_table.h"
#include "roomcast/simulator/sensing/sensor_profile.h"

namespace roomcast::simulator {

/// Overwrites every pixel of `out`.
void fill_unit_noise(DepthPrinciple principle, std::uint32_t key, const GaussianTable& gaussians,
                     ImageView<float> out);

}  // namespace roomcast::simulator
