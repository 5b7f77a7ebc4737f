// SPDX-License-Identifier: Apache-2.0
// Fits the lens of a colour camera and the board's pose in each picture from the board's corners
// (Zhang 2000, as in OpenCV's calibrateCamera). Pixels, metres. Thread-safe (no state).
#pragma once

#include <vector>

#include "roomcast/alignment/calibration/charuco_board.h"
#include "roomcast/alignment/calibration/charuco_finder.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast::alignment::calibration {

struct CornerError {
  Eigen::Vector2d pixel, error_px;  // measured; measured - expected
};

struct LensFit {
  CameraIntrinsics camera;
  std::vector<RigidTransform> camera_from_board;  // one per view
  std::vector<CornerError> errors;
  double rms_px = 0;
};

/// `keep_lens`: the lens `start` is kept, and only the poses are fitted. Each view has at least six
/// corners. kNotFound: too few views (kFewestViews; one if the lens is kept); kMalformed: the
/// corners do not fit a flat board.
[[nodiscard]] Result<LensFit> fit_lens(const CharucoBoard& board,
                                       const std::vector<std::vector<SeenCorner>>& views,
                                       const CameraIntrinsics& start, bool keep_lens);

inline constexpr std::size_t kFewestViews = 6;
inline constexpr std::size_t kFewestCorners = 6;
inline constexpr double kWorstRms_px = 2;

}  // namespace roomcast::alignment::calibration
