// SPDX-License-Identifier: Apache-2.0
// The surface that a depth picture shows: a point and a normal for each pixel, in the depth
// camera's frame, metres. Normals are those of the plane through the neighbours left, right, above
// and below; where the surface breaks off the pixel has none and counts as no surface, which takes
// away the mixed pixels that sensors give at rims. Single-threaded; keeps its memory.
#pragma once

#include <Eigen/Core>

#include "roomcast/core/image.h"
#include "roomcast/geometry/camera_model.h"

namespace roomcast::recording {

class DepthPoints {
 public:
  explicit DepthPoints(const CameraIntrinsics& camera);

  /// `depth_mm` of the camera's size.
  void set(DepthView depth_mm);

  [[nodiscard]] const CameraIntrinsics& camera() const { return camera_; }
  [[nodiscard]] bool has(int x, int y) const { return !normals_.at(x, y).isZero(0); }
  [[nodiscard]] const Eigen::Vector3f& point_m(int x, int y) const { return points_m_.at(x, y); }
  /// Towards the camera.
  [[nodiscard]] const Eigen::Vector3f& normal(int x, int y) const { return normals_.at(x, y); }
  /// Of the reading at a pixel, 0 for none.
  [[nodiscard]] float z_m(int x, int y) const { return points_m_.at(x, y).z(); }

 private:
  void unproject(DepthView depth_mm);
  void find_normal(int x, int y);

  CameraIntrinsics camera_;
  Image<Eigen::Vector2f> rays_;
  Image<Eigen::Vector3f> points_m_;
  Image<Eigen::Vector3f> normals_;
};

/// Two neighbouring readings this far apart in z are not of one surface: some 70 degrees from
/// facing the camera at the usual resolutions, and the noise of a reading.
[[nodiscard]] constexpr float largest_step_m(float z_m) {
  return 0.01F + 0.02F * z_m;
}

/// Standard deviation of a reading; a Kinect's grows with the square of distance (Khoshelham &
/// Oude Elberink 2012).
[[nodiscard]] constexpr float reading_sigma_m(float z_m) {
  return 0.002F + 0.0015F * z_m * z_m;
}

}  // namespace roomcast::recording
