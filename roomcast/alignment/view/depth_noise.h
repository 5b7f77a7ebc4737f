// SPDX-License-Identifier: Apache-2.0
// Standard deviation of a depth reading: one noise model for every test and weight in alignment. It
// grows with the square of distance, as for triangulation and time-of-flight sensors alike
// (Khoshelham & Oude Elberink 2012). The constants exceed the noise of either Kinect generation,
// because the error left after averaging over time is mostly bias.
#pragma once

namespace roomcast::alignment {

[[nodiscard]] constexpr float depth_sigma_m(float z_m) {
  return 0.004F + 0.0015F * z_m * z_m;
}

}  // namespace roomcast::alignment
