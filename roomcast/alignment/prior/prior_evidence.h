// SPDX-License-Identifier: Apache-2.0
// Evidence of placed sensors for or against a prior pose of another sensor: the placed sensor with
// the largest overlap at that pose, and whether the surfaces of both fit. Metres. Thread-safe (no
// state).
#pragma once

#include <optional>
#include <span>

#include "roomcast/alignment/feature/sensor_view.h"
#include "roomcast/alignment/pair/pair_candidates.h"

namespace roomcast::alignment {

/// Another sensor, whose pose is known.
struct PlacedView {
  const SensorView* view = nullptr;
  RigidTransform world_from_depth;
};

/// The placed sensor with the largest overlap if the prior is about right; nothing if none
/// overlaps.
[[nodiscard]] std::optional<PlacedView> best_partner(const SensorView& view,
                                                     const RigidTransform& prior_world_from_depth,
                                                     std::span<const PlacedView> others);

/// The pose candidates of this pair alone.
[[nodiscard]] PairCandidates candidates_of(const SensorView& a, const SensorView& b);

/// The evidence against a pose. A pose with a prior needs less support than one without, but
/// nothing may contradict it.
enum class Contradiction { kNone, kShapes, kColors };
[[nodiscard]] Contradiction contradiction(const PoseEvidence& evidence);

/// Whether one sensor sees through surfaces that the other sees, by more than slightly misaligned
/// edges explain.
[[nodiscard]] bool has_free_space_conflict(const FreeSpaceCheck& space);

}  // namespace roomcast::alignment
