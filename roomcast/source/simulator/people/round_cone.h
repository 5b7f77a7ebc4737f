// SPDX-License-Identifier: Apache-2.0
// The hull of two balls, possibly flattened: what a person's limbs are made of. Rays meet it in
// closed form (a cone tangent to both balls, and the two balls), so a moving person needs no
// acceleration structure. Local frame: the first ball sits at the origin, the second at (0, length,
// 0). Lengths in metres.
#pragma once

#include <optional>

#include <Eigen/Core>

namespace roomcast::sim {

class RoundCone {
 public:
  RoundCone() = default;
  /// The difference of the radii has to be smaller than the length.
  RoundCone(float first_radius_m, float second_radius_m, float length_m);

  /// Smallest t > 0 at which origin + t * direction enters, or nothing. The origin is outside.
  [[nodiscard]] std::optional<float> entry(const Eigen::Vector3f& origin,
                                           const Eigen::Vector3f& direction) const;

  /// Outward normal at a point of the surface, not normalised.
  [[nodiscard]] Eigen::Vector3f normal_at(const Eigen::Vector3f& point) const;

  [[nodiscard]] float first_radius() const { return first_radius_; }
  [[nodiscard]] float second_radius() const { return second_radius_; }
  [[nodiscard]] float length() const { return length_; }

 private:
  float first_radius_ = 0, second_radius_ = 0, length_ = 0;
  float slope_ = 0;  // the cone's radius at height y is intercept_ - slope_ * y
  float intercept_ = 0;
  float low_ = 0, high_ = 0;  // heights between which the surface is the cone
};

}  // namespace roomcast::sim
