// SPDX-License-Identifier: Apache-2.0
// The calibration bundle: what a sensor sends once, on joining, so that it can be placed (the
// paper's "first full-resolution colour image for alignment", with depth added). Depth in
// millimetres in the depth camera's own grid, colour in full resolution, neither registered nor
// undistorted. Plain data.
#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast::alignment {

struct CalibrationBundle {
  std::string name;  // of the sensor, unique in its room
  SensorCalibration calibration;
  DepthImage depth_mm;  // averaged over time; 0 where nothing steady was seen
  ColorImage color;     // averaged over time
  MaskImage moving;     // depth grid; 255 where something moved. May be empty: nothing did
  std::optional<Eigen::Vector3d>
      up;  // against gravity, unit, depth frame: where the sensor has an IMU
};

/// The least share of a depth picture that must hold readings for it to be of any use.
inline constexpr double kMinDepthShare = 0.02;
/// The least spread of grey values (standard deviation, of 255) of a colour picture.
inline constexpr double kMinContrast = 2;

/// kInvalidArgument with a sentence that says what to do about it: cameras that are none, pictures
/// of other sizes than their cameras', hardly any depth, colour without contrast (a covered lens, a
/// dark room).
[[nodiscard]] Status check(const CalibrationBundle& bundle);

}  // namespace roomcast::alignment
