// SPDX-License-Identifier: Apache-2.0
// The surface seen in one depth picture: raw readings and, where the surface is smooth, points with
// normals. Points near depth edges have no normal and are no samples, because flying pixels occur
// there. Metres, in the depth camera's frame. Thread-safe (immutable after being made).
#pragma once

#include <vector>

#include <Eigen/Core>

#include "roomcast/alignment/view/lens.h"
#include "roomcast/alignment/view/window_range.h"
#include "roomcast/core/image.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast::alignment {

struct SurfacePoint {
  Eigen::Vector3f point_m;
  Eigen::Vector3f normal;  // unit, towards the camera
};

struct DepthSurface {
  CameraIntrinsics camera;
  Lens lens;
  Image<float> z_m;                   // raw readings; 0 = none
  WindowRange range;                  // of the readings around each pixel
  Image<SurfacePoint> at;             // smoothed; the normal is 0 where the surface is not smooth
  std::vector<SurfacePoint> samples;  // the smooth points of every kSampleStep-th row and column
};

inline constexpr int kSampleStep = 3;
inline constexpr float kNearestSurface_m = 0.3F;
inline constexpr float kFarthestSurface_m = 7;

/// `depth_mm` has the size of `camera`, which must have been checked.
[[nodiscard]] DepthSurface depth_surface(DepthView depth_mm, const CameraIntrinsics& camera);

}  // namespace roomcast::alignment
