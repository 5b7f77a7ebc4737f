// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/scene/footprint.h"

#include <cmath>

namespace roomcast::simulator {

using Eigen::Vector2f;

Vector2f Footprint::side() const {
  return {std::cos(yaw_rad), -std::sin(yaw_rad)};
}
Vector2f Footprint::front() const {
  return {std::sin(yaw_rad), std::cos(yaw_rad)};
}

Footprint footprint_of(const Eigen::Affine3f& at, const Eigen::Vector3f& size_m) {
  const Eigen::Vector3f front = at.linear().col(2);
  return {{at.translation().x(), at.translation().z()},
          {0.5F * size_m.x(), 0.5F * size_m.z()},
          std::atan2(front.x(), front.z()),
          size_m.y()};
}

bool overlap(const Footprint& a, const Footprint& b, float gap_m) {
  const Vector2f way = b.centre_m - a.centre_m;
  const auto reach = [](const Footprint& f, const Vector2f& axis) {
    return f.half_m.x() * std::abs(f.side().dot(axis)) +
           f.half_m.y() * std::abs(f.front().dot(axis));
  };
  for (const Vector2f& axis : {a.side(), a.front(), b.side(), b.front()}) {
    if (std::abs(way.dot(axis)) >= reach(a, axis) + reach(b, axis) + gap_m) return false;
  }
  return true;
}

bool contains(const Footprint& footprint, const Vector2f& point_m) {
  const Vector2f way = point_m - footprint.centre_m;
  return std::abs(way.dot(footprint.side())) <= footprint.half_m.x() &&
         std::abs(way.dot(footprint.front())) <= footprint.half_m.y();
}

}  // namespace roomcast::simulator
