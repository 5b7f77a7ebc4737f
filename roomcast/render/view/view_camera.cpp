// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/view/view_camera.h"

#include <cmath>
#include <numbers>

#include "roomcast/geometry/camera_model.h"

namespace roomcast::render {
namespace {

Error invalid(const char* sentence) {
  return Error{ErrorCode::kInvalidArgument, sentence};
}

}  // namespace

bool is_legal_side(int pixels) {
  return pixels >= 1 && pixels <= kMaxImageSide;
}

// The comparisons are written so that NaN fails them.
Status ViewCamera::check() const {
  if (!is_legal_side(width) || !is_legal_side(height)) {
    return invalid("the view's width and height must be 1 to 8192 pixels");
  }
  if (!(vertical_fov_rad > 0 && vertical_fov_rad < std::numbers::pi)) {
    return invalid("the view's vertical field of view must lie between 0 and 180 degrees");
  }
  if (!(near_m > 0 && near_m < far_m && std::isfinite(far_m))) {
    return invalid("the view's near and far distances must be positive and in this order");
  }
  if (!world_from_view.rotation.allFinite() || !world_from_view.translation_m.allFinite()) {
    return invalid("the view's pose must consist of finite numbers");
  }
  return {};
}
static_assert(kMaxImageSide == 8192, "the sentence above says so");

double focal_length_px(const ViewCamera& camera) {
  return 0.5 * camera.height / std::tan(0.5 * camera.vertical_fov_rad);
}

ViewAngles view_angles(const ViewCamera& camera) {
  const auto angle_rad = [&camera](double pixels) {
    return std::atan(pixels / focal_length_px(camera));
  };
  const double half_width = 0.5 * camera.width, half_height = 0.5 * camera.height;
  return {angle_rad(std::hypot(half_width, half_height)), angle_rad(half_width),
          angle_rad(half_height)};
}

Eigen::Matrix4f clip_from_view(const ViewCamera& camera) {
  const double focal = focal_length_px(camera);
  const double near = camera.near_m, far = camera.far_m;
  Eigen::Matrix4d clip = Eigen::Matrix4d::Zero();
  clip(0, 0) = 2 * focal / camera.width;
  clip(1, 1) = 2 * focal / camera.height;
  clip(2, 2) = -(far + near) / (far - near);
  clip(2, 3) = -2 * far * near / (far - near);
  clip(3, 2) = -1;
  return clip.cast<float>();
}

RigidTransform optical_from_view() {
  return {Eigen::Vector3d(1, -1, -1).asDiagonal().toDenseMatrix(), Eigen::Vector3d::Zero()};
}

RigidTransform world_from_view_looking_at(const Eigen::Vector3d& eye_m,
                                          const Eigen::Vector3d& target_m) {
  return world_from_optical_looking_at(eye_m, target_m) * optical_from_view();
}

}  // namespace roomcast::render
