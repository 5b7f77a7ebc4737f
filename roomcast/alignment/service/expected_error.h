// SPDX-License-Identifier: Apache-2.0
// Decides whether a newly estimated pose equals the known one within the expected error. No I/O.
#pragma once

#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::alignment {

/// `expected_error_mm`: one standard deviation of the new pose 2.5 m ahead of the sensor. The known
/// pose is assumed to be at most as exact, because it was estimated from less data.
[[nodiscard]] bool is_same_place(const RigidTransform& known, const RigidTransform& now,
                                 double expected_error_mm);

/// Whether the poses differ by no more than the largest error of alignment.
[[nodiscard]] bool is_about_the_same_place(const RigidTransform& known, const RigidTransform& now);

}  // namespace roomcast::alignment
