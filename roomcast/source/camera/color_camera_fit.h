// SPDX-License-Identifier: Apache-2.0
// Some cameras do not tell where their colour camera stands, but where in the colour picture a
// depth reading lies, by tables or polynomials of their own. Roomcast thinks in cameras; here the
// colour camera is found that puts every reading where the device puts it, by Gauss-Newton. Metres,
// pixels with centres at whole numbers. Thread-safe (no state).
#pragma once

#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast::source {

struct MappedPoint {
  Eigen::Vector3d point_m;  // depth camera's frame
  Eigen::Vector2d seen_px;  // in the colour picture, by the device
};

/// Looks for lens, turn about the axis, and shift along x, beginning at `start`. (Turns about x or
/// y are as good as shifting the picture, and cameras beside each other have no other shift.)
/// kMalformed when no camera puts the points within kWorstFit_px of where they should be.
[[nodiscard]] Result<SensorCalibration> fit_color_camera(const SensorCalibration& start,
                                                         const std::vector<MappedPoint>& points);

inline constexpr double kWorstFit_px = 2;  // root mean square
inline constexpr std::size_t kFewestMappedPoints = 500;

/// The same cameras for pictures flipped left to right.
[[nodiscard]] SensorCalibration mirrored(const SensorCalibration& cameras);

}  // namespace roomcast::source
