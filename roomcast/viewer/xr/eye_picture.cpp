// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/xr/eye_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "roomcast/geometry/camera_model.h"

namespace roomcast::viewer::xr {
namespace {

constexpr double kWidest_rad = 1.5;  // from the axis; a plane picture grows to infinity
constexpr int kRounding_px = 2;      // both sides are rounded up

bool is_picture(double low_rad, double high_rad) {
  return low_rad < high_rad && low_rad > -kWidest_rad && high_rad < kWidest_rad;
}

/// Whole pixels on both sides of the axis.
struct Extent {
  int before = 0, after = 0;
  [[nodiscard]] int length() const { return before + after; }
  [[nodiscard]] int centred() const { return 2 * std::max(std::abs(before), std::abs(after)); }
};

Extent extent(double low_rad, double high_rad, double focal_px) {
  return {static_cast<int>(std::ceil(-focal_px * std::tan(low_rad))),
          static_cast<int>(std::ceil(focal_px * std::tan(high_rad)))};
}

float angle(int pixels, double focal_px) {
  return static_cast<float>(std::atan(pixels / focal_px));
}

}  // namespace

Result<EyePicture> eye_picture(const XrFovf& fov, PictureSize size) {
  const bool is_legal = is_picture(fov.angleLeft, fov.angleRight) &&
                        is_picture(fov.angleDown, fov.angleUp) && size.width > kRounding_px &&
                        size.height > kRounding_px;
  if (!is_legal)
    return Error{ErrorCode::kUnsupported, "the headset asks for a picture that cannot be drawn"};
  const double focal_px =
      std::min((size.width - kRounding_px) / (std::tan(fov.angleRight) - std::tan(fov.angleLeft)),
               (size.height - kRounding_px) / (std::tan(fov.angleUp) - std::tan(fov.angleDown)));
  const Extent across = extent(fov.angleLeft, fov.angleRight, focal_px);
  const Extent up = extent(fov.angleDown, fov.angleUp, focal_px);
  EyePicture picture;
  picture.drawn = {across.centred(), up.centred()};
  if (std::max(picture.drawn.width, picture.drawn.height) > kMaxImageSide)
    return Error{ErrorCode::kUnsupported, "the headset asks for a larger picture than 8192 pixels"};
  picture.vertical_fov_rad = 2 * std::atan(0.5 * picture.drawn.height / focal_px);
  picture.left = picture.drawn.width / 2 - across.before;
  picture.bottom = picture.drawn.height / 2 - up.before;
  picture.part = {across.length(), up.length()};
  picture.fov = {-angle(across.before, focal_px), angle(across.after, focal_px),
                 angle(up.after, focal_px), -angle(up.before, focal_px)};
  return picture;
}

EyePicture with_size(const EyePicture& picture, PictureSize size) {
  if (size == picture.drawn) return picture;
  const double focal_px = 0.5 * picture.drawn.height / std::tan(0.5 * picture.vertical_fov_rad);
  EyePicture larger = picture;
  larger.drawn = size;
  larger.vertical_fov_rad = 2 * std::atan(0.5 * size.height / focal_px);
  larger.left += (size.width - picture.drawn.width) / 2;
  larger.bottom += (size.height - picture.drawn.height) / 2;
  return larger;
}

RigidTransform transform_from_pose(const XrPosef& pose) {
  const auto& turn = pose.orientation;
  const auto& place = pose.position;
  const Eigen::Quaterniond rotation(turn.w, turn.x, turn.y, turn.z);
  return {rotation.normalized().toRotationMatrix(), {place.x, place.y, place.z}};
}

XrPosef pose_from_transform(const RigidTransform& transform) {
  const Eigen::Quaternionf turn = Eigen::Quaterniond(transform.rotation).normalized().cast<float>();
  const Eigen::Vector3f place = transform.translation_m.cast<float>();
  return {{turn.x(), turn.y(), turn.z(), turn.w()}, {place.x(), place.y(), place.z()}};
}

}  // namespace roomcast::viewer::xr
