// SPDX-License-Identifier: Apache-2.0
// When a sensor's pose, found anew, is the one that it had: the rest is error. Pure.
#pragma once

#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::alignment {

/// `expected_error_mm`: one standard deviation of the new pose 2.5 m ahead of the sensor. The known
/// one, found when less was known, is thought to be as exact at best.
[[nodiscard]] bool is_same_place(const RigidTransform& known, const RigidTransform& now,
                                 double expected_error_mm);

/// Whether both are the same place for all that alignment can be wrong by.
[[nodiscard]] bool is_about_the_same_place(const RigidTransform& known, const RigidTransform& now);

}  // namespace roomcast::alignment
