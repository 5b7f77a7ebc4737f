// SPDX-License-Identifier: Apache-2.0
// SensorView: a calibration bundle, looked at once from every side that alignment needs: surface,
// picture, planes, floor, features. Half a second of CPU per sensor; everything that compares two
// sensors works on two of these. Thread-safe (immutable after being made).
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

/// Errors of `check`; kInvalidArgument when nothing but depth edges, or one plane, is seen.
[[nodiscard]] Result<SensorView> make_sensor_view(const CalibrationBundle& bundle);

}  // namespace roomcast::alignment
