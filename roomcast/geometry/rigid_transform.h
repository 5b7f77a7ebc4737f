// SPDX-License-Identifier: Apache-2.0
// A rotation and a translation in metres: `a_from_b * point_in_b == point_in_a`.
#pragma once

#include <array>
#include <span>

#include <Eigen/Core>

#include "roomcast/core/result.h"

namespace roomcast {

struct RigidTransform {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation_m = Eigen::Vector3d::Zero();

  [[nodiscard]] Eigen::Vector3d operator*(const Eigen::Vector3d& point_m) const {
    return rotation * point_m + translation_m;
  }
  [[nodiscard]] RigidTransform operator*(const RigidTransform& other) const;
  [[nodiscard]] RigidTransform inverse() const;
  /// Exactly the same numbers.
  friend bool operator==(const RigidTransform& a, const RigidTransform& b) {
    return a.rotation == b.rotation && a.translation_m == b.translation_m;
  }
};

/// Row-major 4x4, as in rig.json, camera.json and on the wire.
[[nodiscard]] std::array<double, 16> row_major_from_transform(const RigidTransform& transform);

/// kMalformed unless there are 16 finite numbers, the last row is 0 0 0 1, and the rotation is one
/// to within 1e-3 (files round). Returns the nearest exactly orthonormal rotation.
[[nodiscard]] Result<RigidTransform> transform_from_row_major(std::span<const double> row_major);

/// The transform with exactly these numbers, which must already be those of a rigid transform. For
/// code that forwards poses: row_major_from_transform() returns the same numbers, bit for bit.
[[nodiscard]] RigidTransform exact_transform_from_row_major(std::span<const double, 16> row_major);

/// The pose of an optical frame (x right, y down, z forward) at `eye_m` looking at `target_m`, with
/// world y up. If it looks straight up or down, the top of the picture is towards world -z.
[[nodiscard]] RigidTransform world_from_optical_looking_at(const Eigen::Vector3d& eye_m,
                                                           const Eigen::Vector3d& target_m);

}  // namespace roomcast
