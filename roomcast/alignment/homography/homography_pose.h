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

struct HomographyPose {
  RigidTransform a_from_b;
  int inliers = 0;  // of the homography
};

/// Nothing when too few corners match or no homography is found.
[[nodiscard]] std::optional<HomographyPose> homography_pose(const SensorView& a,
                                                            const SensorView& b);

/// As in the paper, every sensor is aligned to the first one, which is the origin.
[[nodiscard]] AlignmentReport align_by_homography(
    std::span<const std::shared_ptr<const SensorView>> views);

}  // namespace roomcast::alignment
