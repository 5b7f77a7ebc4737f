// SPDX-License-Identifier: Apache-2.0
// What placed sensors say about where another one is thought to stand: which of them shares most
// with it there, and whether what both see fits. Metres. Thread-safe (no state).
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

/// The placed sensor that shares most with the view if the guess is about right; nothing where none
/// shares anything.
[[nodiscard]] std::optional<PlacedView> best_partner(const SensorView& view,
                                                     const RigidTransform& prior_world_from_depth,
                                                     std::span<const PlacedView> others);

/// Both compared with each other alone.
[[nodiscard]] PairCandidates candidates_of(const SensorView& a, const SensorView& b);

/// Less support is asked for than of a pose that nobody proposed, but nothing may contradict it.
enum class Contradiction { kNone, kShapes, kColors };
[[nodiscard]] Contradiction contradiction(const PoseEvidence& evidence);

/// Whether one looks through what the other sees, by more than edges that are a little off.
[[nodiscard]] bool is_too_much(const FreeSpaceCheck& space);

}  // namespace roomcast::alignment
