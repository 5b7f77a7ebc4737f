// SPDX-License-Identifier: Apache-2.0
// Rotation matrices from and to other descriptions.
#pragma once

#include <Eigen/Core>

namespace roomcast {

/// Radians about `axis`, which need not have unit length; the identity for the zero axis.
[[nodiscard]] Eigen::Matrix3d rotation_about(const Eigen::Vector3d& axis, double angle_rad);

/// The rotation about `vector` by its length in radians.
[[nodiscard]] Eigen::Matrix3d rotation_from_vector(const Eigen::Vector3d& vector);

/// Inverse of rotation_from_vector: the axis, as long as the angle in radians (0 to pi).
[[nodiscard]] Eigen::Vector3d vector_from_rotation(const Eigen::Matrix3d& rotation);

/// The smallest rotation that turns the direction `from` into the direction `to`; of opposite
/// directions, one of the half turns.
[[nodiscard]] Eigen::Matrix3d rotation_between(const Eigen::Vector3d& from,
                                               const Eigen::Vector3d& to);

}  // namespace roomcast
