// SPDX-License-Identifier: Apache-2.0
// How far two poses are apart, and when two hypotheses are the same answer. Thread-safe (no state).
#pragma once

#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::alignment {

struct PoseDifference {
  double angle_rad = 0;
  double distance_m = 0;  // between where they put the point `at_m`
};

/// `at_m` is where the difference matters, in the frame the poses are from: a sensor's view is
/// about 2.5 m ahead of it.
[[nodiscard]] PoseDifference difference(const RigidTransform& one, const RigidTransform& other,
                                        const Eigen::Vector3d& at_m = Eigen::Vector3d(0, 0, 2.5));

/// Whether two hypotheses say different things: not mere inaccuracy of the same answer.
[[nodiscard]] bool are_rivals(const RigidTransform& one, const RigidTransform& other);

}  // namespace roomcast::alignment
