// SPDX-License-Identifier: Apache-2.0
// DepthPoints: a point and a normal for each pixel of a depth picture, in the depth camera's frame,
// metres. The normal is that of the plane through the left, right, upper and lower neighbours.
// Pixels at a depth discontinuity have no normal and do not count as surface, which removes the
// mixed pixels that sensors produce at edges. Single-threaded; reuses its memory.
#pragma once

#include <Eigen/Core>

#include "roomcast/core/image.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast::recording {

class DepthPoints {
 public:
  explicit DepthPoints(const CameraIntrinsics& camera);

  /// `depth_mm` must have the camera's size.
  void set(DepthView depth_mm);

  [[nodiscard]] const CameraIntrinsics& camera() const { return camera_; }
  [[nodiscard]] bool has(int x, int y) const { return !normals_.at(x, y).isZero(0); }
  [[nodiscard]] const Eigen::Vector3f& point_m(int x, int y) const { return points_m_.at(x, y); }
  /// Unit normal, pointing towards the camera.
  [[nodiscard]] const Eigen::Vector3f& normal(int x, int y) const { return normals_.at(x, y); }
  /// Depth at a pixel in metres, 0 for none.
  [[nodiscard]] float z_m(int x, int y) const { return points_m_.at(x, y).z(); }

 private:
  void unproject(DepthView depth_mm);
  void find_normal(int x, int y);

  CameraIntrinsics camera_;
  Image<Eigen::Vector2f> rays_;
  Image<Eigen::Vector3f> points_m_;
  Image<Eigen::Vector3f> normals_;
};

/// Maximum difference in z between neighbouring readings of one surface: allows surfaces tilted by
/// some 70 degrees at the usual resolutions, plus the noise of a reading.
[[nodiscard]] constexpr float largest_step_m(float z_m) {
  return 0.01F + 0.02F * z_m;
}

/// Standard deviation of a reading; it grows with the square of distance (Kinect: Khoshelham & Oude
/// Elberink 2012).
[[nodiscard]] constexpr float reading_sigma_m(float z_m) {
  return 0.002F + 0.0015F * z_m * z_m;
}

}  // namespace roomcast::recording
