// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/rig/rig_check.h"

#include <algorithm>
#include <tuple>

#include "roomcast/alignment/pair/planar_texture.h"

namespace roomcast::alignment {
namespace {

constexpr double kRefinedConflict = 0.0275, kNegligibleRefinedViolation = 0.004;
constexpr double kRefinedSolidConflict = 0.012, kNegligibleSolid = 12;  // blocks
// Share of judged places whose prints differ: sensors of one room leave a tenth of it at most. Two
// sensors of another, tiled room with the same greys and hues left 0.5 and 0.9 %, which was no more
// than 0.2 and 0.4 % of a view.
constexpr double kPrintConflict = 0.003, kNegligiblePrints = 0.0015;  // shares of a view
constexpr double kHueConflict = 0.3;  // share of places alike in grey
constexpr double kExactColors = 0.8, kMinPrints = 0.04;
constexpr std::ptrdiff_t kMajority = 3;

/// Evidence of all other sensors about one sensor's pose.
struct SeenByOthers {
  double consistent = 0, violating = 0;              // shares of views
  double solid_consistent = 0, solid_violating = 0;  // blocks
  PlanarTexture prints;

  void add(const PoseEvidence& evidence) {
    consistent += evidence.space.consistent;
    violating += evidence.space.violating;
    solid_consistent += static_cast<double>(evidence.solid.consistent);
    solid_violating += static_cast<double>(evidence.solid.violating);
  }
  /// Contradiction relative to the allowed limit; above 1 the pose cannot be true. The limits are
  /// stricter than those of candidates, because refined poses are exact.
  [[nodiscard]] double contradiction() const {
    const double conflict = violating / (consistent + violating + 1e-3);
    const double solid_conflict = solid_violating / (solid_consistent + solid_violating + 1);
    double worst = 0;
    if (violating > kNegligibleRefinedViolation)
      worst = std::max(worst, conflict / kRefinedConflict);
    if (solid_violating > kNegligibleSolid)
      worst = std::max(worst, solid_conflict / kRefinedSolidConflict);
    if (prints.contradicting > kNegligiblePrints)
      worst = std::max(worst, prints.conflict() / kPrintConflict);
    if (prints.alike > kMinPrints) worst = std::max(worst, prints.hue_conflict() / kHueConflict);
    return worst;
  }
};

/// Texture comparison of a placed pair on shared walls, floors and tables.
struct SeenPrints {
  const RigPair* pair;
  PlanarTexture prints;
};

/// Marks sensors whose colours agree with another sensor's: such colours are aligned with depth.
void find_exact_colors(std::span<const SeenPrints> all, std::vector<bool>& exact) {
  for (const SeenPrints& seen : all) {
    if (seen.prints.judged < kMinPrints || seen.prints.correlation() < kExactColors) continue;
    exact[seen.pair->first] = exact[seen.pair->second] = true;
  }
}

/// Adds the prints of pairs whose colours are aligned with depth; misaligned colours are not
/// evidence. With three or more such sensors, one per pair suffices: a sensor that agrees with none
/// of them is the wrong one.
void add_prints(std::span<const SeenPrints> all, const std::vector<bool>& exact,
                std::vector<SeenByOthers>& seen) {
  const bool one_will_do = std::ranges::count(exact, true) >= kMajority;
  for (const auto& [pair, prints] : all) {
    const bool first = exact[pair->first], second = exact[pair->second];
    if (one_will_do ? !first && !second : !first || !second) continue;
    seen[pair->first].prints.add(prints);
    seen[pair->second].prints.add(prints);
  }
}

std::vector<SeenByOthers> seen_by_others(std::span<const RigPair> pairs, const RigAnswer& answer,
                                         std::vector<bool>& exact_colors) {
  std::vector<SeenByOthers> seen(answer.placed.size());
  std::vector<SeenPrints> prints;
  for (const RigPair& pair : pairs) {
    if (!answer.placed[pair.first] || !answer.placed[pair.second]) continue;
    const PoseEvidence evidence = pair.candidates->examine(answer.relative(pair));
    seen[pair.first].add(evidence);
    seen[pair.second].add(evidence);
    prints.push_back({&pair, compare_planar_texture(pair.candidates->a(), pair.candidates->b(),
                                                    answer.state(pair))});
  }
  find_exact_colors(prints, exact_colors);
  add_prints(prints, exact_colors, seen);
  return seen;
}

}  // namespace

std::optional<std::size_t> RigCheck::contradicted_sensor(std::span<const RigPair> pairs,
                                                         const RigAnswer& answer) {
  exact_colors_.resize(answer.placed.size());
  const std::vector<SeenByOthers> seen = seen_by_others(pairs, answer, exact_colors_);
  const auto rank = [&](std::size_t i) {
    const PoseSelection& selection = answer.selection;
    return std::tuple(seen[i].contradiction(), i != selection.origin,
                      -std::min(selection.margin_to_rival[i], selection.margin_to_unplaced[i]));
  };
  std::optional<std::size_t> worst;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i].contradiction() > 1 && (!worst || rank(i) > rank(*worst))) worst = i;
  }
  return worst;
}

}  // namespace roomcast::alignment
