// SPDX-License-Identifier: Apache-2.0
// The alignment of the paper (Lesniak & Tucker 2018), kept for comparison: Harris corners, matched
// by the correlation of the patches around them, a homography by RANSAC, and its pose. A homography
// leaves four poses and no scale; depth selects and scales one. The method cannot detect its own
// failure. Metres. Thread-safe; it sets OpenCV's process-wide thread count to one.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "roomcast/alignment/feature/sensor_view.h"
#include "roomcast/alignment/rig/alignment_report.h"

namespace roomcast::alignment {

/// OpenCV's usual values, else by hand.
struct HomographyOptions {
  int max_corners = 800;
  double min_quality = 0.002;  // of a corner, for the best one
  double min_apart_px = 5;     // corners
  double harris_k = 0.04;      // Harris & Stephens 1988
  int patch_reach_px = 5;      // patches of 11 x 11 pixels
  float min_correlation = 0.8F;
  int min_matches = 8;
  double inlier_px = 3;
  int ransac_trials = 5000;
  double confidence = 0.999;
  std::size_t min_lifted = 3;  // matches with depth, for the scale

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("max_corners", max_corners, Range{4, 1e6});
    visit("min_quality", min_quality, Range{1e-6, 1});
    visit("min_apart_px", min_apart_px, Range{0, 1000});
    visit("harris_k", harris_k, Range{0, 1});
    visit("patch_reach_px", patch_reach_px, Range{1, 100});
    visit("min_correlation", min_correlation, Range{-1, 1});
    visit("min_matches", min_matches, Range{4, 1e6});
    visit("inlier_px", inlier_px, Range{0.01, 1000});
    visit("ransac_trials", ransac_trials, Range{1, 1e6});
    visit("confidence", confidence, Range{0.01, 0.999999});
    visit("min_lifted", min_lifted, Range{1, 1e6});
  }
  [[nodiscard]] Status check() const { return check_fields("HomographyOptions", *this); }
};

struct HomographyPose {
  RigidTransform a_from_b;
  int inliers = 0;  // of the homography
};

/// Nothing when too few corners match or no homography is found.
[[nodiscard]] std::optional<HomographyPose> homography_pose(const SensorView& a,
                                                            const SensorView& b,
                                                            const HomographyOptions& options = {});

/// As in the paper, every sensor is aligned to the first one, which is the origin.
[[nodiscard]] AlignmentReport align_by_homography(
    std::span<const std::shared_ptr<const SensorView>> views,
    const HomographyOptions& options = {});

}  // namespace roomcast::alignment
