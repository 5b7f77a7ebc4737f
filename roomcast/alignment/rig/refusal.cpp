// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/rig/refusal.h"

#include <fmt/format.h>

namespace roomcast::alignment {
namespace {

constexpr auto kAlternativeHint =
    "in the running room walk through both views or hold a printed board into them";

std::string names(const PairCandidates& pair) {
  return fmt::format("{} and {}", pair.a().name, pair.b().name);
}

const SensorView* view_with_few_features(const PairCandidates& pair, std::size_t few) {
  for (const SensorView* view : {&pair.a(), &pair.b()}) {
    if (view->picture_features.size() + view->rectified_features.size() < few) return view;
  }
  return nullptr;
}

}  // namespace

std::string why_pair_is_refused(const PairCandidates& pair, const RefusalOptions& options) {
  const EvidenceOptions& evidence = pair.options().evidence;
  if (pair.same_pictures()) {
    return fmt::format("{} gave the very same pictures; one of them is a copy of the other",
                       names(pair));
  }
  if (const SensorView* view = view_with_few_features(pair, options.few_features)) {
    return fmt::format("{} sees hardly any texture; put something with a pattern into its view",
                       view->name);
  }
  if (pair.ranked().empty() || pair.ranked()[0].score < evidence.min_margin) {
    return fmt::format(
        "no overlap of {} was found; turn them towards each other's view until at "
        "least a tenth is common, or {}",
        names(pair), kAlternativeHint);
  }
  const PoseEvidence& best = pair.ranked()[0];
  if (best.leaves_motion_unexplained) {
    return fmt::format(
        "something moves in both {}, but not where their best pose has it (something repeats); put "
        "something unique into both views",
        names(pair));
  }
  if (pair.margin() < evidence.min_margin) {
    return fmt::format(
        "several poses of {} fit about equally well (something repeats); put something unique into "
        "both views",
        names(pair));
  }
  if (is_strong(best, evidence)) return {};
  if (best.space.consistent < options.little_overlap) {
    return fmt::format(
        "{} share only about {:.0f} % of their views; turn them towards each other, or {}",
        names(pair), 100 * best.space.consistent, kAlternativeHint);
  }
  return fmt::format(
      "too few places agree between {} ({} found); turn them towards each other, or put something "
      "with a pattern into both views",
      names(pair), best.matches.cells);
}

std::string why_pair_says_little(const PairCandidates& pair, const PoseEvidence& at_placed_pose,
                                 const RefusalOptions& options) {
  if (at_placed_pose.space.consistent < options.little_overlap) {
    return fmt::format("{} share only about {:.0f} % of their views; placed through other sensors",
                       names(pair), 100 * at_placed_pose.space.consistent);
  }
  return fmt::format(
      "{} have too few places in common to align on their own; placed through other "
      "sensors",
      names(pair));
}

}  // namespace roomcast::alignment
