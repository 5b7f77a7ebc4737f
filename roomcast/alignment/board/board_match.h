// SPDX-License-Identifier: Apache-2.0
// Relative pose of two sensors, from a printed tag that both saw at the same times at several
// places. The corners of the tag are 3-D points for each sensor, so many poses of the tag give the
// transform like any matched points (Kabsch 1976; outliers removed by RANSAC in a fixed order). A
// single place of the tag is not sufficient. Metres, seconds. Thread-safe (no state).
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
  int poses = 0;                 // of the tag that agree with a_from_b
};

/// Both sorted by time, on one clock. kUnavailable: the message says what is missing.
[[nodiscard]] Result<BoardMatch> match_boards(std::span<const TagSighting> a,
                                              std::span<const TagSighting> b);

}  // namespace roomcast::alignment
