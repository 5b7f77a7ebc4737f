// SPDX-License-Identifier: Apache-2.0
// Standard deviation of a depth reading: one noise model for every test and weight in alignment. It
// grows with the square of distance, as for triangulation and time-of-flight sensors alike
// (Khoshelham & Oude Elberink 2012).
#pragma once

#include "roomcast/core/option_fields.h"

namespace roomcast::alignment {

/// Beyond the noise of either Kinect generation, because what averaging leaves is mostly bias.
struct DepthNoiseOptions {
  float constant_m = 0.004F;
  float per_square_metre_m = 0.0015F;  // times the square of the depth in metres

  [[nodiscard]] constexpr float sigma_m(float z_m) const {
    return constant_m + per_square_metre_m * z_m * z_m;
  }
  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("constant_m", constant_m, Range{1e-5, 1});
    visit("per_square_metre_m", per_square_metre_m, Range{0, 1});
  }
  [[nodiscard]] Status check() const { return check_fields("DepthNoiseOptions", *this); }
};

/// By the usual options.
[[nodiscard]] constexpr float depth_sigma_m(float z_m) {
  return DepthNoiseOptions{}.sigma_m(z_m);
}

}  // namespace roomcast::alignment
