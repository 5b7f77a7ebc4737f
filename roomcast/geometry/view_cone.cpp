// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/view_cone.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace roomcast {

ViewBounds::Angle::Angle(double radians)
    : sine(static_cast<float>(std::sin(std::min(radians, std::numbers::pi)))),
      cosine(static_cast<float>(std::cos(std::min(radians, std::numbers::pi)))) {}

namespace {

/// Of a view with an upward direction. Beyond a right angle, a side bounds nothing.
bool has_bound(const ViewCone& cone, double angle_rad, float beside_rad) {
  return angle_rad > 0 && angle_rad + beside_rad < std::numbers::pi / 2 && !cone.up.isZero();
}

}  // namespace

ViewBounds::ViewBounds(const ViewCone& cone, float beside_rad)
    : eye_m_(cone.eye_m),
      forward_(cone.forward),
      up_(cone.up),
      right_(cone.forward.cross(cone.up)),
      corner_(cone.angles.half_angle_rad + beside_rad),
      side_(cone.angles.half_width_rad + beside_rad),
      top_(cone.angles.half_height_rad + beside_rad),
      has_sides_(has_bound(cone, cone.angles.half_width_rad, beside_rad)),
      has_top_(has_bound(cone, cone.angles.half_height_rad, beside_rad)) {}

// The distance from the cone's edge and from the planes of the picture's sides; it holds for cones
// of more than half the surroundings, too.
float ViewBounds::distance_outside(const Eigen::Vector3f& away_m) const {
  const float ahead = away_m.dot(forward_);
  const float aside = std::sqrt(std::max(0.0F, away_m.squaredNorm() - ahead * ahead));
  const auto beyond = [ahead](float across, const Angle& angle) {
    return across * angle.cosine - ahead * angle.sine;
  };
  float outside = beyond(aside, corner_);
  if (has_sides_) outside = std::max(outside, beyond(std::abs(away_m.dot(right_)), side_));
  if (has_top_) outside = std::max(outside, beyond(std::abs(away_m.dot(up_)), top_));
  return outside;
}

}  // namespace roomcast
