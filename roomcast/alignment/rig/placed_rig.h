// SPDX-License-Identifier: Apache-2.0
// Computes the report from the pairs' candidates: selection, joint refinement, check, world frame.
// Metres. Thread-safe (no state).
#pragma once

#include <span>
#include <vector>

#include "roomcast/alignment/rig/alignment_report.h"
#include "roomcast/alignment/rig/pose_selection.h"

namespace roomcast::alignment {

/// `pairs` are all pairs of `views`.
[[nodiscard]] AlignmentReport place_rig(std::span<const SensorView* const> views,
                                        std::span<const RigPair> pairs);

}  // namespace roomcast::alignment
