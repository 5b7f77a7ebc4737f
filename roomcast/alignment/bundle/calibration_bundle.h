// SPDX-License-Identifier: Apache-2.0
// The calibration bundle: the data that a sensor sends once on joining, so that its pose can be
// estimated (the paper's "first full-resolution colour image for alignment", with depth added).
// Depth in millimetres in the depth camera's own grid, colour in full resolution, neither
// registered nor undistorted. Plain data.
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
  DepthImage depth_mm;  // averaged over time; 0 where no steady reading exists
  ColorImage color;     // averaged over time
  MaskImage moving;     // depth grid; 255 at pixels that moved. Empty if nothing moved
  std::optional<Eigen::Vector3d>
      up;  // against gravity, unit, depth frame: where the sensor has an IMU
};

/// Least share of pixels with a reading in a usable depth picture.
inline constexpr double kMinDepthShare = 0.02;
/// Least standard deviation of the grey values (of 255) of a usable colour picture.
inline constexpr double kMinContrast = 2;

/// kInvalidArgument with a sentence that names the remedy: invalid camera parameters, pictures that
/// are not of their cameras' sizes, hardly any depth, colour without contrast (a covered lens, a
/// dark room).
[[nodiscard]] Status check(const CalibrationBundle& bundle);

}  // namespace roomcast::alignment
