// SPDX-License-Identifier: Apache-2.0
// Lets a hypothesis settle: a few quick steps on few surface points and the features that agree, so
// that hypotheses which mean the same end up the same, and can be judged. Metres. Thread-safe (no
// state).
#pragma once

#include <span>

#include "roomcast/align/pair/rigid_fit.h"
#include "roomcast/align/sensor_view.h"

namespace roomcast::align {

/// From up to about 10 cm away.
[[nodiscard]] RigidTransform settled_pose(const SensorView& a, const SensorView& b,
                                          std::span<const PointMatch> matches,
                                          const RigidTransform& a_from_b);

}  // namespace roomcast::align
