// SPDX-License-Identifier: Apache-2.0
// Support of matches for a pose. Many features on one small object are a single observation, so
// support counts the places in space that agree: the sum over cells of the best match's
// weight. Metres. Thread-safe (no state).
#pragma once

#include <span>
#include <vector>

#include "roomcast/alignment/pair/rigid_fit.h"
#include "roomcast/core/option_fields.h"

namespace roomcast::alignment {

struct MatchSupportOptions {
  float weight_cell_m = 0.10F;  // side of a cell whose best match counts; by hand
  float count_cell_m = 0.05F;   // side of a cell that counts as a place; the prototype's

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("weight_cell_m", weight_cell_m, Range{0.005, 10});
    visit("count_cell_m", count_cell_m, Range{0.005, 10});
  }
  [[nodiscard]] Status check() const { return check_fields("MatchSupportOptions", *this); }
};

struct MatchSupport {
  double weight = 0;  // sum over cells of the best match's weight
  int cells = 0;      // smaller cells with any agreeing match
};

[[nodiscard]] std::vector<PointMatch> agreeing_matches(std::span<const PointMatch> matches,
                                                       const RigidTransform& a_from_b,
                                                       float tolerance_m);

[[nodiscard]] MatchSupport match_support(std::span<const PointMatch> agreeing,
                                         const MatchSupportOptions& options = {});

}  // namespace roomcast::alignment
