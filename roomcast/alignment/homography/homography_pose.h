// SPDX-License-Identifier: Apache-2.0
// The paper's own alignment (Lesniak & Tucker 2018), kept to compare with: Harris corners, matched
// by the correlation of the patches around them, a homography by RANSAC, and the pose it stands
// for. A homography leaves four poses and no scale; depth chooses and scales. It has no way to know
// that it failed. Metres. Thread-safe; OpenCV's thread count, which is the process's, is set to
// one.
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

/// As in the paper every sensor is aligned to the first one, which stands in the origin.
[[nodiscard]] AlignmentReport align_by_homography(
    std::span<const std::shared_ptr<const SensorView>> views);

}  // namespace roomcast::alignment
