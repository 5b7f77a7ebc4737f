// SPDX-License-Identifier: Apache-2.0
// SensorView: everything that alignment derives from a calibration bundle: surface, picture,
// planes, floor, features. It takes half a second of CPU per sensor. All comparisons of two sensors
// use two SensorViews. Thread-safe (immutable after being made).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "roomcast/alignment/bundle/calibration_bundle.h"
#include "roomcast/alignment/feature/feature_set.h"
#include "roomcast/alignment/view/color_picture.h"
#include "roomcast/alignment/view/depth_surface.h"
#include "roomcast/alignment/view/planes.h"
#include "roomcast/alignment/view/texture.h"

namespace roomcast::alignment {

struct SensorView {
  std::string name;
  DepthSurface surface;
  ColorPicture picture;
  Texture texture;
  std::vector<Plane> planes;
  std::optional<Plane> floor;
  FeatureSet picture_features, rectified_features;
};

/// Errors: those of `check`; kInvalidArgument when the sensor sees too little smooth surface or
/// only one plane.
[[nodiscard]] Result<SensorView> make_sensor_view(const CalibrationBundle& bundle);

}  // namespace roomcast::alignment
