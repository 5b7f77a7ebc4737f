// SPDX-License-Identifier: Apache-2.0
// Can both views be true at once? Every surface point of one must, where it falls into the other's
// picture, be seen there (consistent), hidden behind something nearer (occluded), or outside; a
// surface where the other sensor looks through free space, or one seen from behind, violates.
// Checked both ways. Smooth surfaces only, so flying and moving pixels are never held against a
// pose. Metres. Thread-safe (no state).
#pragma once

#include "roomcast/alignment/view/depth_surface.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::alignment {

/// Shares of the tested points.
struct FreeSpaceCheck {
  double consistent = 0, violating = 0, occluded = 0;
  double consistent_least = 0;  // the smaller of both directions: the overlap

  /// Of what could be judged.
  [[nodiscard]] double conflict() const { return violating / (consistent + violating + 1e-3); }
};

/// Blocks of both views, about 1.6 degrees wide and high.
struct SolidConflict {
  std::size_t consistent = 0, violating = 0;
};

/// Like check_free_space, but only what is in the way as a whole counts: a thing that one sensor
/// sees where the other looks through. Edges that are a little off are not solid.
[[nodiscard]] SolidConflict check_solid_conflict(const DepthSurface& a, const DepthSurface& b,
                                                 const RigidTransform& a_from_b);

/// How many points of each view alignment tests.
inline constexpr std::size_t kTestedPoints = 1500;

/// `points`: how many of each view are tested, at most.
[[nodiscard]] FreeSpaceCheck check_free_space(const DepthSurface& a, const DepthSurface& b,
                                              const RigidTransform& a_from_b, std::size_t points);

}  // namespace roomcast::alignment
