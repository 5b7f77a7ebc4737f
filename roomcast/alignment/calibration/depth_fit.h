// SPDX-License-Identifier: Apache-2.0
// Where the depth camera stands beside the colour camera, and by what scale and bias its readings
// are off, from planes: the colour camera knows where the board was, and every depth reading on the
// board should lie in that plane (as in Herrera, Kannala & Heikkila 2012, without their
// distortion of depth). Least squares by Gauss-Newton, reweighted against flying pixels (Cauchy).
// Metres. Thread-safe (no state).
#pragma once

#include <vector>

#include "roomcast/alignment/calibration/charuco_board.h"
#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast::alignment::calibration {

/// What is looked for: true z = scale * reading + bias.
struct DepthModel {
  RigidTransform color_from_depth;
  double scale = 1;
  double bias_m = 0;
};

struct BoardDepth {
  const DepthImage* depth_mm;  // one view
  RigidTransform color_from_board;
};

/// One view, before and after.
struct PlaneError {
  double distance_m = 0;
  std::size_t readings = 0;
  double mean_before_mm = 0;  // readings behind the board are positive
  double mean_after_mm = 0;
  double rms_after_mm = 0;
};

struct DepthFit {
  DepthModel model;
  std::vector<PlaneError> views;  // in the order given; those without readings have 0
  /// One standard deviation by the noise of depth alone: whether the views determine it at all.
  /// What the lens and the board's poses are off by comes on top, and is about ten times as much.
  double translation_sigma_mm = 0, rotation_sigma_deg = 0, bias_sigma_mm = 0;
};

/// `cameras.color` is the fitted lens, `cameras.color_from_depth` where to begin. Where colour is
/// registered, depth is looked at by the colour camera, and only scale and bias are looked for.
/// kNotFound: fewer than kFewestDepthViews views have readings on the board.
[[nodiscard]] Result<DepthFit> fit_depth(const CharucoBoard& board,
                                         const std::vector<BoardDepth>& views,
                                         const SensorCalibration& cameras);

inline constexpr std::size_t kFewestDepthViews = 6;

}  // namespace roomcast::alignment::calibration
