// SPDX-License-Identifier: Apache-2.0
// The calibration bundle: the data that a sensor sends once on joining, so that its pose can be
// estimated (the paper's "first full-resolution colour image for alignment", with depth added).
// Depth in millimetres in the depth camera's own grid, colour in full resolution, neither
// registered nor undistorted. Plain data.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "roomcast/alignment/bundle/depth_instants.h"
#include "roomcast/core/image.h"
#include "roomcast/core/option_fields.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast::alignment {

struct CalibrationBundle {
  std::string name;  // of the sensor, unique in its room
  SensorCalibration calibration;
  DepthImage depth_mm;  // averaged over time; 0 where no steady reading exists
  ColorImage color;     // averaged over time
  MaskImage moving;     // depth grid; 255 at pixels that moved. Empty if nothing moved
  std::vector<DepthInstant> instants;  // at times that the sensors share; may be empty
  /// Factor by which the sensor has multiplied its readings; nothing: it cannot be told another.
  std::optional<double> depth_scale;
  std::optional<Eigen::Vector3d>
      up;  // against gravity, unit, depth frame: where the sensor has an IMU
};

/// What makes a bundle usable. Chosen by hand, far below what any sensor that sees a room gives.
struct BundleCheckOptions {
  double min_depth_share = 0.02;  // of the pixels: with a reading
  double min_contrast = 2;        // grey levels of 255: standard deviation of the colour picture

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("min_depth_share", min_depth_share, Range{0, 1});
    visit("min_contrast", min_contrast, Range{0, 255});
  }
  [[nodiscard]] Status check() const { return check_fields("BundleCheckOptions", *this); }
};

/// kInvalidArgument with a sentence that names the remedy: invalid camera parameters, pictures that
/// are not of their cameras' sizes, hardly any depth, colour without contrast (a covered lens, a
/// dark room).
[[nodiscard]] Status check(const CalibrationBundle& bundle, const BundleCheckOptions& options = {});

}  // namespace roomcast::alignment
