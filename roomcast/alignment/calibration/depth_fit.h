// SPDX-License-Identifier: Apache-2.0
// Fits the pose of the depth camera relative to the colour camera, and scale and bias of its
// readings, from planes: the board's pose is known from the colour camera, and every depth reading
// on the board should be in that plane (as in Herrera, Kannala & Heikkila 2012, without their
// distortion of depth). Least squares by Gauss-Newton, reweighted against flying pixels (Cauchy).
// Metres. Thread-safe (no state).
#pragma once

#include <vector>

#include "roomcast/alignment/calibration/charuco_board.h"
#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast::alignment::calibration {

/// The unknowns: true z = scale * reading + bias.
struct DepthModel {
  RigidTransform color_from_depth;
  double scale = 1;
  double bias_m = 0;
};

struct BoardDepth {
  const DepthImage* depth_mm;  // one view
  RigidTransform color_from_board;
};

/// The plane error of one view, before and after the fit.
struct PlaneError {
  double distance_m = 0;
  std::size_t readings = 0;
  double mean_before_mm = 0;  // readings behind the board are positive
  double mean_after_mm = 0;
  double rms_after_mm = 0;
};

struct DepthFit {
  DepthModel model;
  std::vector<PlaneError> views;  // in the order given; 0 for views without readings
  /// One standard deviation due to depth noise alone: it shows whether the views determine the
  /// parameters. Errors of the lens and of the board's poses are added to it and are about ten
  /// times as large.
  double translation_sigma_mm = 0, rotation_sigma_deg = 0, bias_sigma_mm = 0;
};

/// `cameras.color` is the fitted lens, `cameras.color_from_depth` the start of the fit. If colour
/// is registered, depth is seen from the colour camera, and only scale and bias are fitted.
/// kNotFound: fewer than kFewestDepthViews views have readings on the board.
[[nodiscard]] Result<DepthFit> fit_depth(const CharucoBoard& board,
                                         const std::vector<BoardDepth>& views,
                                         const SensorCalibration& cameras);

inline constexpr std::size_t kFewestDepthViews = 6;

}  // namespace roomcast::alignment::calibration
