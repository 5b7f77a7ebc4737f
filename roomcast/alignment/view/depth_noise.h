// SPDX-License-Identifier: Apache-2.0
// How far a depth reading is to be trusted: one noise model for every test and weight of alignment.
// Grows with the square of distance, as triangulation and time-of-flight alike do (Khoshelham &
// Oude Elberink 2012); the constants lie above the noise of a Kinect of either kind, because what
// remains after averaging over time is mostly bias.
#pragma once

namespace roomcast::alignment {

[[nodiscard]] constexpr float depth_sigma_m(float z_m) {
  return 0.004F + 0.0015F * z_m * z_m;
}

}  // namespace roomcast::alignment
