// SPDX-License-Identifier: Apache-2.0
// How two sensors stand to each other, from a printed tag that both saw at the same times, held
// here and there. The tag's corners are points in space for each of them, so many poses of it give
// the transform as any matched points do (Kabsch 1976, without outliers by RANSAC in a fixed
// order). One place of the tag never suffices. Metres, seconds. Thread-safe (no state).
#pragma once

#include <array>
#include <span>

#include <Eigen/Core>

#include "roomcast/core/result.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::alignment {

struct TagSighting {
  double time_s = 0;
  int tag = 0;
  std::array<Eigen::Vector3d, 4> corners_m;
};

struct BoardMatch {
  RigidTransform a_from_b;
  double expected_error_mm = 0;  // one standard deviation, 2.5 m in front of b
  int poses = 0;                 // of the tag that agree
};

/// Both in the order of time, on one clock. kUnavailable: what is missing.
[[nodiscard]] Result<BoardMatch> match_boards(std::span<const TagSighting> a,
                                              std::span<const TagSighting> b);

}  // namespace roomcast::alignment
