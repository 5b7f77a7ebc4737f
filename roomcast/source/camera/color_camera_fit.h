// SPDX-License-Identifier: Apache-2.0
// Fits a colour camera to a device's own mapping from depth readings to colour pixels. Some devices
// give no colour camera, but tables or polynomials for that mapping; roomcast needs a camera model.
// Method: Gauss-Newton on the reprojection error. Metres, pixels with centres at integers.
// Thread-safe (no state).
#pragma once

#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast::source {

struct MappedPoint {
  Eigen::Vector3d point_m;  // in the depth camera's frame
  Eigen::Vector2d seen_px;  // in the colour picture, from the device
};

/// Estimates the lens, the roll about the optical axis and the shift along x, beginning at `start`.
/// (Rotations about x and y are equivalent to shifting the picture, and cameras side by side have
/// no other shift.) kMalformed if no camera maps the points with an error of at most kWorstFit_px.
[[nodiscard]] Result<SensorCalibration> fit_color_camera(const SensorCalibration& start,
                                                         const std::vector<MappedPoint>& points);

inline constexpr double kWorstFit_px = 2;  // root mean square
inline constexpr std::size_t kFewestMappedPoints = 500;

/// The calibration for pictures mirrored left to right.
[[nodiscard]] SensorCalibration mirrored(const SensorCalibration& cameras);

}  // namespace roomcast::source
