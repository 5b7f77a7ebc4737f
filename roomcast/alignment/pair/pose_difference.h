// SPDX-License-Identifier: Apache-2.0
// Difference between two poses, and the test whether two hypotheses are the same answer.
// Thread-safe (no state).
#pragma once

#include <numbers>

#include "roomcast/core/option_fields.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::alignment {

struct PoseDifference {
  double angle_rad = 0;
  double distance_m = 0;  // between their images of the point `at_m`
};

/// `at_m` is the point, in the poses' source frame, at which the distance is measured: a sensor's
/// view is about 2.5 m ahead of it.
[[nodiscard]] PoseDifference difference(const RigidTransform& one, const RigidTransform& other,
                                        const Eigen::Vector3d& at_m = Eigen::Vector3d(0, 0, 2.5));

/// The inaccuracy of one answer: more makes two answers. Chosen on the development rooms
/// (alignment_options.h).
struct RivalOptions {
  double angle_rad = 4 * std::numbers::pi / 180;
  double distance_m = 0.2;
  /// Answers that rest on the same matches are one answer, if they differ by less than this: lenses
  /// that are off keep a pose from fitting everywhere, and where it fits is left to refinement. A
  /// half turn and a shift by one period rest on other matches (ADR 20).
  double common_matches = 0.7;    // share of the matches of either
  double share_of_matches = 0.8;  // of a pair, relative to the mean of the sensor's pairs
  double same_angle_rad = 12 * std::numbers::pi / 180, same_distance_m = 0.3;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("angle_rad", angle_rad, Range{0, std::numbers::pi});
    visit("distance_m", distance_m, Range{0, 10});
    visit("common_matches", common_matches, Range{0, 1});
    visit("share_of_matches", share_of_matches, Range{0, 1});
    visit("same_angle_rad", same_angle_rad, Range{0, std::numbers::pi});
    visit("same_distance_m", same_distance_m, Range{0, 10});
  }
  [[nodiscard]] Status check() const { return check_fields("RivalOptions", *this); }
};

/// Whether two hypotheses differ by more than the inaccuracy of one answer.
[[nodiscard]] bool are_rivals(const RigidTransform& one, const RigidTransform& other,
                              const RivalOptions& options = {});

}  // namespace roomcast::alignment
