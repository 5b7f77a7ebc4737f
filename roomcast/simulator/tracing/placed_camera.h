// SPDX-License-Identifier: Apache-2.0
// PlacedCamera: a camera with its pose, and its lens model evaluated per pixel. Metres; directions
// have z = 1 in the optical frame, so a distance along one is the depth. Immutable.
#pragma once

#include <optional>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "roomcast/core/image.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::simulator {

/// Columns left <= x < right, rows top <= y < bottom.
struct PixelBox {
  int left = 0, top = 0, right = 0, bottom = 0;
  [[nodiscard]] bool empty() const { return right <= left || bottom <= top; }
};

class PlacedCamera {
 public:
  PlacedCamera(const CameraIntrinsics& intrinsics, const RigidTransform& world_from_camera);

  [[nodiscard]] int width() const { return intrinsics_.width; }
  [[nodiscard]] int height() const { return intrinsics_.height; }
  [[nodiscard]] const RigidTransform& world_from_camera() const { return world_from_camera_; }
  [[nodiscard]] const Eigen::Vector3f& eye_m() const { return eye_m_; }
  [[nodiscard]] const Eigen::Matrix3f& axes() const {
    return axes_;
  }  // of the optical frame in the world
  [[nodiscard]] float pixel_angle() const { return pixel_angle_; }  // radians per pixel, about

  /// (x/z, y/z) of a pixel, and rows of each component.
  [[nodiscard]] Eigen::Vector2f ray(int x, int y) const {
    return {ray_x_.at(x, y), ray_y_.at(x, y)};
  }
  [[nodiscard]] const float* ray_x_row(int y) const { return ray_x_.view().row(y); }
  [[nodiscard]] const float* ray_y_row(int y) const { return ray_y_.view().row(y); }

  /// Contains the rays of all pixels.
  [[nodiscard]] const Eigen::AlignedBox2f& ray_bounds() const { return ray_bounds_; }

  /// A ray's direction in the world.
  [[nodiscard]] Eigen::Vector3f direction(const Eigen::Vector2f& ray) const {
    return axes_.col(0) * ray.x() + axes_.col(1) * ray.y() + axes_.col(2);
  }
  [[nodiscard]] Eigen::Vector3f direction(int x, int y) const { return direction(ray(x, y)); }
  /// World point at pixel (x, y) and depth z.
  [[nodiscard]] Eigen::Vector3f point(int x, int y, float z_m) const {
    return eye_m_ + z_m * direction(x, y);
  }

  /// Projection of a point of the optical frame; nothing if it is behind the camera, or where the
  /// lens model is not injective.
  [[nodiscard]] std::optional<Eigen::Vector2f> pixel_of(const Eigen::Vector3f& in_camera_m) const;

  /// Smallest box of pixels that contains an axis-aligned box of a local frame; the whole picture
  /// if part of the box is behind the camera.
  [[nodiscard]] PixelBox pixels_of_box(const Eigen::Affine3f& world_from_local,
                                       const Eigen::Vector3f& low,
                                       const Eigen::Vector3f& high) const;

 private:
  CameraIntrinsics intrinsics_;
  RigidTransform world_from_camera_, camera_from_world_;
  Eigen::Vector3f eye_m_;
  Eigen::Matrix3f axes_;
  float pixel_angle_;
  Image<float> ray_x_, ray_y_;
  Eigen::AlignedBox2f ray_bounds_;
};

}  // namespace roomcast::simulator
