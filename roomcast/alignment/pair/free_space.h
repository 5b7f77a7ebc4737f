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

/// Points of each view tested by alignment.
inline constexpr std::size_t kTestedPoints = 1500;
/// A block is a square of so many points.
inline constexpr int kBlockPoints = 4;

/// Sigmas are of the depth noise; wide, because hypotheses are tested before they are refined.
/// Chosen on the development rooms (alignment_options.h), unless noted.
struct FreeSpaceOptions {
  std::size_t points = kTestedPoints;  // of each view
  float in_front_sigmas = 8;           // nearer than all readings around: in free space
  float behind_sigmas = 5;             // further than all readings around: occluded
  float same_reading_sigmas = 10;      // consistent
  float same_surface_m = 0.02F;        // only paper is this thin and seen from both sides
  float from_behind_cosine = -0.3F;    // of the normal to the view; below: seen from behind
  int border_px = 4;                   // where depth cameras have few readings; by hand
  int points_across = 170;             // a picture, about, in blocks
  int min_of_block = 12;               // points, for the whole block to count

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("points", points, Range{1, 1e6});
    visit("in_front_sigmas", in_front_sigmas, Range{0, 1000});
    visit("behind_sigmas", behind_sigmas, Range{0, 1000});
    visit("same_reading_sigmas", same_reading_sigmas, Range{0, 1000});
    visit("same_surface_m", same_surface_m, Range{0, 1});
    visit("from_behind_cosine", from_behind_cosine, Range{-1, 0});
    visit("border_px", border_px, Range{0, 1000});
    visit("points_across", points_across, Range{1, 10000});
    visit("min_of_block", min_of_block, Range{1, kBlockPoints * kBlockPoints});
  }
  [[nodiscard]] Status check() const { return check_fields("FreeSpaceOptions", *this); }
};

/// Shares of the tested points.
struct FreeSpaceCheck {
  double consistent = 0, violating = 0, occluded = 0;
  double min_consistent = 0;  // the smaller of both directions: the overlap

  /// Share of violating points among consistent and violating ones.
  [[nodiscard]] double conflict() const { return violating / (consistent + violating + 1e-3); }
};

/// Numbers of blocks of both views; a block is about 1.6 degrees wide and high as usual.
struct SolidConflict {
  std::size_t consistent = 0, violating = 0;
};

/// Like check_free_space, but counts whole blocks only: objects that one sensor sees and the other
/// looks through. Slightly misplaced edges do not count.
[[nodiscard]] SolidConflict check_solid_conflict(const DepthSurface& a, const DepthSurface& b,
                                                 const RigidTransform& a_from_b,
                                                 const FreeSpaceOptions& options = {});

/// `points`: about how many points of each view are tested.
[[nodiscard]] FreeSpaceCheck check_free_space(const DepthSurface& a, const DepthSurface& b,
                                              const RigidTransform& a_from_b, std::size_t points,
                                              const FreeSpaceOptions& options = {});

}  // namespace roomcast::alignment
