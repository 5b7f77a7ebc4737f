// SPDX-License-Identifier: Apache-2.0
// The rigid motion that maps points to their partners, by weighted least squares (Kabsch 1976;
// Umeyama 1991). Metres. Thread-safe (no state).
#pragma once

#include <optional>
#include <span>

#include <Eigen/Core>

#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::alignment {

/// A point seen by both sensors of a pair.
struct PointMatch {
  Eigen::Vector3f a_m, b_m;          // in the depth frames
  Eigen::Vector2f a_pixel, b_pixel;  // in the colour pictures
  float weight = 1;                  // 0..1
};

/// `weights` are not negative, one per match. Nothing if fewer than three are positive, or if those
/// points are on a line.
[[nodiscard]] std::optional<RigidTransform> fit_a_from_b(std::span<const PointMatch> matches,
                                                         std::span<const float> weights);

/// Distance between a and b, with b transformed to a's frame.
[[nodiscard]] inline float distance_m(const Eigen::Matrix3f& rotation, const Eigen::Vector3f& shift,
                                      const PointMatch& match) {
  return (rotation * match.b_m + shift - match.a_m).norm();
}

}  // namespace roomcast::alignment
