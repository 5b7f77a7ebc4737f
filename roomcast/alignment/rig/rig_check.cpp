// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/rig/rig_check.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace roomcast::alignment {
namespace {

/// Evidence of all other sensors about one sensor's pose.
struct SeenByOthers {
  double consistent = 0, violating = 0;              // shares of views
  double solid_consistent = 0, solid_violating = 0;  // blocks
  PlanarTexture prints;
  double uncalibrated_belief = 0;
  double moving_agreement = 0;  // sum over pairs

  void add(const PoseEvidence& evidence, const RigCheckOptions& options) {
    consistent += evidence.space.consistent;
    violating += evidence.space.violating;
    solid_consistent += static_cast<double>(evidence.solid.consistent);
    solid_violating += static_cast<double>(evidence.solid.violating);
    if (static_cast<double>(evidence.solid.consistent) >= options.vouching_solid)
      moving_agreement += evidence.moving_agreement;
  }
  /// Contradiction relative to the allowed limit; above 1 the pose cannot be true.
  [[nodiscard]] double contradiction(const RigCheckOptions& options) const {
    const double conflict = violating / (consistent + violating + 1e-3);
    const double solid_conflict = solid_violating / (solid_consistent + solid_violating + 1);
    const bool is_vouched_for = moving_agreement >= options.vouching_pairs;
    const double vouched = is_vouched_for ? uncalibrated_belief : 0;
    const double max_conflict =
        std::lerp(options.max_conflict,
                  is_vouched_for ? options.max_vouched_conflict : options.max_uncalibrated_conflict,
                  uncalibrated_belief);
    const double max_solid =
        std::lerp(options.max_solid_conflict, options.max_vouched_solid, vouched);
    double worst = 0;
    if (violating > options.negligible_violation) worst = std::max(worst, conflict / max_conflict);
    if (solid_violating > options.negligible_solid)
      worst = std::max(worst, solid_conflict / max_solid);
    if (vouched < 0.5 && prints.contradicting > options.negligible_prints)
      worst = std::max(worst, prints.conflict() / options.max_print_conflict);
    if (prints.alike > options.min_prints)
      worst = std::max(worst, prints.hue_conflict() / options.max_hue_conflict);
    return worst;
  }
};

/// Texture comparison of a placed pair on shared walls, floors and tables.
struct SeenPrints {
  const RigPair* pair;
  PlanarTexture prints;
};

/// Marks sensors whose colours agree with another sensor's: such colours are aligned with depth.
void find_exact_colors(std::span<const SeenPrints> all, const RigCheckOptions& options,
                       std::vector<bool>& exact) {
  for (const SeenPrints& seen : all) {
    if (seen.prints.judged < options.min_prints || seen.prints.correlation() < options.exact_colors)
      continue;
    exact[seen.pair->first] = exact[seen.pair->second] = true;
  }
}

/// Adds the prints of pairs whose colours are aligned with depth; misaligned colours are not
/// evidence. With three or more such sensors, one per pair suffices: a sensor that agrees with none
/// of them is the wrong one.
void add_prints(std::span<const SeenPrints> all, const std::vector<bool>& exact, int majority,
                std::vector<SeenByOthers>& seen) {
  const bool one_will_do = std::ranges::count(exact, true) >= majority;
  for (const auto& [pair, prints] : all) {
    const bool first = exact[pair->first], second = exact[pair->second];
    if (one_will_do ? !first && !second : !first || !second) continue;
    seen[pair->first].prints.add(prints);
    seen[pair->second].prints.add(prints);
  }
}

std::vector<SeenByOthers> seen_by_others(std::span<const RigPair> pairs, const RigAnswer& answer,
                                         const RigCheckOptions& options,
                                         std::vector<bool>& exact_colors) {
  std::vector<SeenByOthers> seen(answer.placed.size());
  for (std::size_t i = 0; i < seen.size(); ++i)
    seen[i].uncalibrated_belief = answer.refined[i].uncalibrated_belief;
  std::vector<SeenPrints> prints;
  for (const RigPair& pair : pairs) {
    if (!answer.placed[pair.first] || !answer.placed[pair.second]) continue;
    const PairOptions& limits = pair.candidates->options();
    const PoseEvidence evidence = pair.candidates->examine(answer.relative(pair));
    seen[pair.first].add(evidence, options);
    seen[pair.second].add(evidence, options);
    prints.push_back({&pair, compare_planar_texture(pair.candidates->a(), pair.candidates->b(),
                                                    answer.state(pair), limits.planar_texture,
                                                    limits.reprojection)});
  }
  find_exact_colors(prints, options, exact_colors);
  add_prints(prints, exact_colors, options.majority, seen);
  return seen;
}

}  // namespace

std::optional<std::size_t> RigCheck::contradicted_sensor(std::span<const RigPair> pairs,
                                                         const RigAnswer& answer) {
  exact_colors_.resize(answer.placed.size());
  const std::vector<SeenByOthers> seen = seen_by_others(pairs, answer, options_, exact_colors_);
  const auto rank = [&](std::size_t i) {
    const PoseSelection& selection = answer.selection;
    return std::tuple(seen[i].contradiction(options_), i != selection.origin,
                      -std::min(selection.margin_to_rival[i], selection.margin_to_unplaced[i]));
  };
  std::optional<std::size_t> worst;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i].contradiction(options_) > 1 && (!worst || rank(i) > rank(*worst))) worst = i;
  }
  return worst;
}

}  // namespace roomcast::alignment
