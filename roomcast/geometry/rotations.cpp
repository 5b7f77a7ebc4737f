// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/rotations.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace roomcast {

Eigen::Matrix3d rotation_about(const Eigen::Vector3d& axis, double angle_rad) {
  const double length = axis.norm();
  if (!(length > 0)) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle_rad, axis / length).toRotationMatrix();
}

Eigen::Matrix3d rotation_from_vector(const Eigen::Vector3d& vector) {
  return rotation_about(vector, vector.norm());
}

Eigen::Vector3d vector_from_rotation(const Eigen::Matrix3d& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() * turn.axis();
}

Eigen::Matrix3d rotation_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  constexpr double kOpposite = 1e-12;
  const Eigen::Vector3d unit_from = from.normalized(), unit_to = to.normalized();
  const double cosine = unit_from.dot(unit_to);
  if (1 + cosine < kOpposite) return rotation_about(unit_from.unitOrthogonal(), std::numbers::pi);
  const Eigen::Vector3d cross = unit_from.cross(unit_to);
  return rotation_about(cross, std::atan2(cross.norm(), cosine));
}

}  // namespace roomcast
