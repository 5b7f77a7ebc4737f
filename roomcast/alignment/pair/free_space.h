// SPDX-License-Identifier: Apache-2.0
// Checks whether two views are consistent with a pose. Every surface point of one view must be seen
// in the other's picture (consistent), be hidden behind something nearer (occluded) or project
// outside the picture. A surface in the other sensor's free space, or one seen from behind,
// violates the pose. Checked both ways. Only smooth surfaces are used, so flying and moving pixels
// never count against a pose. Metres. Thread-safe (no state).
#pragma once

#include "roomcast/alignment/view/depth_surface.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::alignment {

/// Shares of the tested points.
struct FreeSpaceCheck {
  double consistent = 0, violating = 0, occluded = 0;
  double min_consistent = 0;  // the smaller of both directions: the overlap

  /// Share of violating points among consistent and violating ones.
  [[nodiscard]] double conflict() const { return violating / (consistent + violating + 1e-3); }
};

/// Numbers of blocks of both views; a block is about 1.6 degrees wide and high.
struct SolidConflict {
  std::size_t consistent = 0, violating = 0;
};

/// Like check_free_space, but counts whole blocks only: objects that one sensor sees and the other
/// looks through. Slightly misplaced edges do not count.
[[nodiscard]] SolidConflict check_solid_conflict(const DepthSurface& a, const DepthSurface& b,
                                                 const RigidTransform& a_from_b);

/// Points of each view tested by alignment.
inline constexpr std::size_t kTestedPoints = 1500;

/// `points`: about how many points of each view are tested.
[[nodiscard]] FreeSpaceCheck check_free_space(const DepthSurface& a, const DepthSurface& b,
                                              const RigidTransform& a_from_b, std::size_t points);

}  // namespace roomcast::alignment
