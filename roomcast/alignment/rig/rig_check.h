// SPDX-License-Identifier: Apache-2.0
// Checks whether a refined answer can be true, against all that its sensors see of one another,
// also where no feature was found: surfaces that one sensor sees and another looks through, and
// differing texture on walls and floors. This detects poses that fit only by a floor's pattern.
// Single-threaded.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "roomcast/alignment/rig/pose_selection.h"
#include "roomcast/alignment/rig/rig_refinement.h"

namespace roomcast::alignment {

/// Limits of what all other sensors say against a refined pose. They are stricter than those of
/// candidates, because refined poses are exact. Shares, unless noted.
struct RigCheckOptions {
  // Surfaces: chosen on the development rooms (alignment_options.h).
  double max_conflict = 0.0275, negligible_violation = 0.004;
  /// Of sensors that are not calibrated: their surfaces are in each other's way at true poses, too
  /// (ADR 18).
  double max_uncalibrated_conflict = 0.055;
  double max_solid_conflict = 0.012, negligible_solid = 12;  // the second in blocks
  /// Of sensors that are not calibrated, where what moves agrees in so many of their pairs: half
  /// turns and shifts move it away. Then wrong lenses may leave more, and their prints, whose
  /// colour is displaced too, are not judged. Four sensors of a studio left up to 7.7 % of surfaces
  /// and 4.8 % of blocks, at poses of which all were right (simulated; ADR 23).
  double vouching_pairs = 1.5, max_vouched_conflict = 0.11, max_vouched_solid = 0.06;
  /// Blocks of surface that a pair must share besides, or a person who stays where he is fits many
  /// poses: on a glossy floor three sensors shared 10 at most, and were wrong by 0.7 to 1.1 m.
  double vouching_solid = 100;

  // Prints that differ, of the texture judged and of a view: sensors of one room leave a tenth of
  // it at most. Two sensors of another, tiled room with the same greys and hues left 0.5 and 0.9 %,
  // which was no more than 0.2 and 0.4 % of a view (ADR 12).
  double max_print_conflict = 0.003, negligible_prints = 0.0015;
  double max_hue_conflict = 0.3;  // of places alike in grey (ADR 12)
  double min_prints = 0.04;       // of a view: less is no evidence of hues (ADR 12)
  double exact_colors = 0.8;      // correlation of colours that are aligned with depth
  int majority = 3;  // sensors whose colours agree, so that one that disagrees is wrong

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("max_conflict", max_conflict, Range{1e-6, 1});
    visit("max_uncalibrated_conflict", max_uncalibrated_conflict, Range{1e-6, 1});
    visit("negligible_violation", negligible_violation, Range{0, 1});
    visit("max_solid_conflict", max_solid_conflict, Range{1e-6, 1});
    visit("negligible_solid", negligible_solid, Range{0, 1e6});
    visit("vouching_pairs", vouching_pairs, Range{0, 1e6});
    visit("vouching_solid", vouching_solid, Range{0, 1e6});
    visit("max_vouched_conflict", max_vouched_conflict, Range{1e-6, 1});
    visit("max_vouched_solid", max_vouched_solid, Range{1e-6, 1});
    visit("max_print_conflict", max_print_conflict, Range{1e-6, 1});
    visit("negligible_prints", negligible_prints, Range{0, 1});
    visit("max_hue_conflict", max_hue_conflict, Range{1e-6, 1});
    visit("min_prints", min_prints, Range{0, 1});
    visit("exact_colors", exact_colors, Range{-1, 1});
    visit("majority", majority, Range{2, 1000});
  }
  [[nodiscard]] Status check() const { return check_fields("RigCheckOptions", *this); }
};

/// A refined answer: which sensors are placed, and where.
struct RigAnswer {
  PoseSelection selection;
  std::vector<bool> placed;
  std::vector<RefinedSensor> refined;
  /// Selected, but no pair holds at the refined poses; not placed. Empty: none.
  std::vector<bool> unheld = {};

  [[nodiscard]] RigidTransform relative(const RigPair& pair) const {
    return refined[pair.first].origin_from_sensor.inverse() *
           refined[pair.second].origin_from_sensor;
  }
  [[nodiscard]] bool is_unheld(const RigPair& pair) const {
    return !unheld.empty() && (unheld[pair.first] || unheld[pair.second]);
  }
  [[nodiscard]] PairState state(const RigPair& pair) const {
    return {relative(pair), refined[pair.first].correction, refined[pair.second].correction};
  }
};

/// Checks successive answers for the same sensors.
class RigCheck {
 public:
  explicit RigCheck(const RigCheckOptions& options = {}) : options_(options) {}

  /// The sensor whose refined pose contradicts the views of all others most; nothing if none does.
  /// Of equals, one that is not the origin, then the one with the smaller margin.
  [[nodiscard]] std::optional<std::size_t> contradicted_sensor(std::span<const RigPair> pairs,
                                                               const RigAnswer& answer);

 private:
  RigCheckOptions options_;
  std::vector<bool> exact_colors_;  // sensors whose colours agreed with another's in any check
};

}  // namespace roomcast::alignment
