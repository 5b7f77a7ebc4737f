// SPDX-License-Identifier: Apache-2.0
// Difference between two poses, and the test whether two hypotheses are the same answer.
// Thread-safe (no state).
#pragma once

#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::alignment {

struct PoseDifference {
  double angle_rad = 0;
  double distance_m = 0;  // between their images of the point `at_m`
};

/// `at_m` is the point, in the poses' source frame, at which the distance is measured: a sensor's
/// view is about 2.5 m ahead of it.
[[nodiscard]] PoseDifference difference(const RigidTransform& one, const RigidTransform& other,
                                        const Eigen::Vector3d& at_m = Eigen::Vector3d(0, 0, 2.5));

/// Whether two hypotheses differ by more than the inaccuracy of one answer.
[[nodiscard]] bool are_rivals(const RigidTransform& one, const RigidTransform& other);

}  // namespace roomcast::alignment
