// SPDX-License-Identifier: Apache-2.0
// Registration: the paper's Algorithm 1 (Lesniak & Tucker 2018): every depth pixel gets the colour that the colour
// camera saw at the same surface point. Colour is down-sampled to the depth grid.
#pragma once

#include <vector>

#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast {

/// Colour in the depth grid, and where it is to be believed.
struct RegisteredColor {
  ColorImage color;  // depth size; black where `seen` is 0
  MaskImage seen;    // 255 where the colour camera saw this surface; 0 without depth, outside its picture, or occluded
};

struct RegistrationOptions {
  /// A surface this much behind the nearest one in the same colour pixel is occluded: metres + share of its z.
  double occlusion_margin_m = 0.015;
  double occlusion_margin_per_m = 0.015;
};

/// Precomputes what depends on the calibration only; `run` allocates nothing after its first call.
class Registration {
 public:
  static Result<Registration> create(const SensorCalibration& calibration,
                                     const RegistrationOptions& options = {});

  /// kInvalidArgument when the sizes are not those of the calibration.
  [[nodiscard]] Status run(DepthView depth_mm, ColorView color, RegisteredColor& out);
  // ... private state is the implementer's
};

}  // namespace roomcast
