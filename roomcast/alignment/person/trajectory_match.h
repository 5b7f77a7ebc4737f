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

#include <array>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "roomcast/core/option_fields.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::alignment {

/// Chosen on simulated walks (docs/benchmarks/live-alignment.md), unless noted.
struct TrajectoryMatchOptions {
  // Times.
  double max_gap_s = 0.35;  // between sightings of b, to be joined by a line
  double max_step_m = 0.5;  // that a person walks in such a gap; by hand
  double min_apart_s = 1;   // the two moments of a hypothesis
  std::array<double, 6> other_offsets_s = {-5,  -3, -1.5,
                                           1.5, 3,  5};  // at which a walk must not fit

  // Places.
  double same_height_m = 0.12;     // heads of one person
  double min_apart_m = 0.7;        // the two moments of a hypothesis
  double same_distance_m = 0.2;    // between them, seen by both
  double max_distance_m = 0.25;    // of a moment that agrees with a hypothesis
  std::size_t tried_moments = 60;  // hypotheses are pairs of about so many

  // Prior on the depth of a head: half a head, with hair, is about 98 mm deep (the mean of its
  // length and its breadth). The centre of the visible surface of a ball is 2/3 of that in front of
  // its centre, of an upright cylinder pi / 4; a head's crown is in between.
  double inside_m = 0.0705, inside_sigma_m = 0.012;
  double across_sigma_m = 0.02, along_sigma_m = 0.035;  // of a sighting
  double independent_s = 0.5;    // errors of sightings closer in time are correlated
  double shape_sigma_m = 0.012;  // heads are not spheres
  int refinements = 8;
  double max_pause_s = 0.5;  // longer ones between two moments do not count as seen

  // Requirements on a result.
  int min_moments = 25;
  double min_seconds = 3;
  double min_share = 0.5;         // of the moments in which both saw a person
  double max_rival_share = 0.75;  // of the moments that agree
  double max_error_mm = 60;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("max_gap_s", max_gap_s, Range{0.01, 60});
    visit("max_step_m", max_step_m, Range{0.01, 100});
    visit("min_apart_s", min_apart_s, Range{0, 60});
    visit("other_offsets_s", other_offsets_s, Range{-60, 60});
    visit("same_height_m", same_height_m, Range{0, 10});
    visit("min_apart_m", min_apart_m, Range{0, 10});
    visit("same_distance_m", same_distance_m, Range{0, 10});
    visit("max_distance_m", max_distance_m, Range{0, 10});
    visit("tried_moments", tried_moments, Range{2, 10000});
    visit("inside_m", inside_m, Range{0, 1});
    visit("inside_sigma_m", inside_sigma_m, Range{1e-5, 1});
    visit("across_sigma_m", across_sigma_m, Range{1e-5, 1});
    visit("along_sigma_m", along_sigma_m, Range{1e-5, 1});
    visit("independent_s", independent_s, Range{0.001, 60});
    visit("shape_sigma_m", shape_sigma_m, Range{0, 1});
    visit("refinements", refinements, Range{1, 1000});
    visit("max_pause_s", max_pause_s, Range{0.01, 60});
    visit("min_moments", min_moments, Range{2, 1e6});
    visit("min_seconds", min_seconds, Range{0, 3600});
    visit("min_share", min_share, Range{0, 1});
    visit("max_rival_share", max_rival_share, Range{0, 1});
    visit("max_error_mm", max_error_mm, Range{0.001, 10000});
  }
  [[nodiscard]] Status check() const { return check_fields("TrajectoryMatchOptions", *this); }
};

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
                                                  std::span<const HeadSighting> b,
                                                  const TrajectoryMatchOptions& options = {});

}  // namespace roomcast::alignment
