// SPDX-License-Identifier: Apache-2.0
// The part of the floor that something stands on: a rectangle at any angle. Metres, radians;
// plan coordinates are (x, z), headings as in furniture.h.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace roomcast::simulator {

struct Footprint {
  Eigen::Vector2f centre_m = Eigen::Vector2f::Zero();
  Eigen::Vector2f half_m = Eigen::Vector2f::Zero();  // across its front, and from front to back
  float yaw_rad = 0;
  float height_m = 0;

  /// Unit vector along its front, from right to left as it looks.
  [[nodiscard]] Eigen::Vector2f side() const;
  [[nodiscard]] Eigen::Vector2f front() const;
};

[[nodiscard]] Footprint footprint_of(const Eigen::Affine3f& at, const Eigen::Vector3f& size_m);

/// Whether two footprints are nearer than `gap_m`, about (exact for gap 0: separating axes).
[[nodiscard]] bool overlap(const Footprint& a, const Footprint& b, float gap_m);
[[nodiscard]] bool contains(const Footprint& footprint, const Eigen::Vector2f& point_m);

}  // namespace roomcast::simulator
