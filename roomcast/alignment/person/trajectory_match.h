// SPDX-License-Identifier: Apache-2.0
// Relative pose of two sensors without overlap, from a person who walked through both views: heads
// seen at the same time must be at the same place. Both floors are known, so the unknowns are a
// turn about the vertical and a shift along the floor. Two moments give a hypothesis (RANSAC,
// Fischler & Bolles 1981, deterministic: moments are tried in a fixed order). All agreeing moments
// give the result (weighted least squares). A third kind of unknown is the distance from the
// visible surface of a head to its centre, which biases sensors that face each other. A walk is
// rejected if it fits equally well at another time offset, as a straight walk at constant speed
// does, or if it covers too small an area. Metres, radians, seconds. Thread-safe (no state).
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
  Eigen::Vector3d seen_m;         // centre of the visible surface of its crown
  Eigen::Vector2d away = {0, 0};  // along the floor (x, z), away from the sensor; unit
};

/// The sighting in the level frame. The sensor's position is needed for `away`.
[[nodiscard]] HeadSighting head_sighting(const RigidTransform& level_from_depth, double time_s,
                                         const Eigen::Vector3d& seen_in_depth_m);

struct TrajectoryMatch {
  RigidTransform a_from_b;       // of the level frames: turns about y, shifts along x and z
  double expected_error_mm = 0;  // one standard deviation, where the walk was
  double seconds = 0;            // in which both saw the heads
  int moments = 0;               // that agree with a_from_b
};

/// Both sorted by time, on one clock. kUnavailable: the walk does not determine the pose; the
/// message gives the reason and what would help.
[[nodiscard]] Result<TrajectoryMatch> match_walks(std::span<const HeadSighting> a,
                                                  std::span<const HeadSighting> b);

}  // namespace roomcast::alignment
