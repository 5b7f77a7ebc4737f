// SPDX-License-Identifier: Apache-2.0
// Footprint: the rectangle, at any angle, of the floor that an object occupies. Metres, radians;
// plan coordinates are (x, z), headings as in furniture.h.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace roomcast::simulator {

struct Footprint {
  Eigen::Vector2f centre_m = Eigen::Vector2f::Zero();
  Eigen::Vector2f half_m = Eigen::Vector2f::Zero();  // widthwise, and from front to back
  float yaw_rad = 0;
  float height_m = 0;

  /// Unit vector along the front, from right to left as seen from the object.
  [[nodiscard]] Eigen::Vector2f side() const;
  [[nodiscard]] Eigen::Vector2f front() const;
};

[[nodiscard]] Footprint footprint_of(const Eigen::Affine3f& at, const Eigen::Vector3f& size_m);

/// True if two footprints are closer than about `gap_m` (exact for gap 0: separating axes).
[[nodiscard]] bool overlap(const Footprint& a, const Footprint& b, float gap_m);
[[nodiscard]] bool contains(const Footprint& footprint, const Eigen::Vector2f& point_m);

}  // namespace roomcast::simulator
