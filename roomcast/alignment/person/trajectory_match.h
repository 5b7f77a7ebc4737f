// SPDX-License-Identifier: Apache-2.0
// How two sensors that share nothing stand to each other, from somebody who walked through both
// views: heads seen at the same times have to be at the same places. With both floors known, what
// is left are a turn about the vertical and a shift along the floor. Two moments give a hypothesis
// (RANSAC, Fischler & Bolles 1981, without chance: moments are tried in a fixed order), all moments
// together the answer (weighted least squares), with how deep inside a head lies behind what is
// seen of it as a third kind of unknown: it is what puts opposite sensors off. A walk that fits as
// well at another time, as a straight one at even pace does, or that hardly leaves the spot, is
// refused. Metres, radians, seconds. Thread-safe (no state).
#pragma once

#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "roomcast/core/result.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::alignment {

/// A head as seen in a level frame (y up, the floor at y = 0).
struct HeadSighting {
  double time_s = 0;
  Eigen::Vector3d seen_m;         // middle of what is seen of its crown
  Eigen::Vector2d away = {0, 0};  // along the floor (x, z), away from the sensor; unit
};

/// Of a sensor: its point of view is needed for `away`.
[[nodiscard]] HeadSighting head_sighting(const RigidTransform& level_from_depth, double time_s,
                                         const Eigen::Vector3d& seen_in_depth_m);

struct TrajectoryMatch {
  RigidTransform a_from_b;       // of the level frames: turns about y, shifts along x and z
  double expected_error_mm = 0;  // one standard deviation, where the walk was
  double seconds = 0;            // that both saw them
  int moments = 0;               // that agree
};

/// Both in the order of time, on one clock. kUnavailable: why the walk does not settle it, and what
/// would.
[[nodiscard]] Result<TrajectoryMatch> match_walks(std::span<const HeadSighting> a,
                                                  std::span<const HeadSighting> b);

}  // namespace roomcast::alignment
