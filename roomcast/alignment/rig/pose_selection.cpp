// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/rig/pose_selection.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "roomcast/alignment/pair/pose_difference.h"

namespace roomcast::alignment {
namespace {

constexpr double kNoRival = 99;

struct SelectionRules {
  PoseSelectionOptions selection;
  RivalOptions rivals;
  EvidenceOptions evidence;
};

bool is_same_answer(const PlacedGroups& one, const PlacedGroups& other,
                    const RivalOptions& rivals) {
  if (one.group != other.group) return false;
  for (std::size_t i = 0; i < one.group.size(); ++i) {
    if (are_rivals(one.group_from_sensor[i], other.group_from_sensor[i], rivals)) return false;
  }
  return true;
}

/// The evidence of pairs for any pose, also for one that is not among their hypotheses; each is
/// examined once.
class LoopEvidence {
 public:
  LoopEvidence(std::span<const RigPair> pairs, const SelectionRules& rules)
      : pairs_(pairs), rules_(rules), examined_(pairs.size()) {}

  const PoseEvidence& at(std::size_t pair, const RigidTransform& a_from_b) {
    for (const PoseEvidence& known : pairs_[pair].candidates->ranked()) {
      if (!are_rivals(known.a_from_b, a_from_b, rules_.rivals)) return known;
    }
    for (const PoseEvidence& known : examined_[pair]) {
      const PoseDifference apart = difference(known.a_from_b, a_from_b);
      if (apart.angle_rad < rules_.selection.same_angle_rad &&
          apart.distance_m < rules_.selection.same_distance_m)
        return known;
    }
    examined_[pair].push_back(pairs_[pair].candidates->examine(a_from_b));
    return examined_[pair].back();
  }

 private:
  std::span<const RigPair> pairs_;
  const SelectionRules& rules_;
  std::vector<std::vector<PoseEvidence>> examined_;
};

/// An edge of the tree: a hypothesis of a pair.
struct Edge {
  std::size_t pair;
  const PoseEvidence* evidence;
};

std::vector<Edge> edges_of(std::span<const RigPair> pairs, const SelectionRules& rules) {
  std::vector<Edge> edges;
  for (std::size_t pair = 0; pair < pairs.size(); ++pair) {
    std::size_t taken = 0;
    for (const PoseEvidence& evidence : pairs[pair].candidates->ranked()) {
      if (taken == rules.selection.edges_per_pair) break;
      if (evidence.score < rules.evidence.pose_cost) continue;
      edges.push_back({pair, &evidence});
      ++taken;
    }
  }
  return edges;
}

PlacedGroups unplaced_groups(std::size_t sensors) {
  PlacedGroups placement;
  for (std::size_t i = 0; i < sensors; ++i) placement.group.push_back(i);
  placement.group_from_sensor.resize(sensors);
  return placement;
}

/// `before` with the groups of the edge's two sensors merged.
PlacedGroups joined(const PlacedGroups& before, const RigPair& pair,
                    const RigidTransform& a_from_b) {
  PlacedGroups after = before;
  const std::size_t group_a = before.group[pair.first], group_b = before.group[pair.second];
  const RigidTransform ga_from_gb = before.group_from_sensor[pair.first] * a_from_b *
                                    before.group_from_sensor[pair.second].inverse();
  const std::size_t kept = std::min(group_a, group_b);
  const RigidTransform moved_from = kept == group_a ? ga_from_gb : ga_from_gb.inverse();
  for (std::size_t i = 0; i < after.group.size(); ++i) {
    if (after.group[i] != std::max(group_a, group_b)) continue;
    after.group[i] = kept;
    after.group_from_sensor[i] = moved_from * before.group_from_sensor[i];
  }
  return after;
}

/// Pooled evidence of all pairs that this edge connects.
PooledEvidence pooled_evidence(const PlacedGroups& before, const PlacedGroups& after,
                               std::span<const RigPair> pairs, const Edge& edge,
                               LoopEvidence& evidence) {
  PooledEvidence pooled;
  pooled.add(*edge.evidence);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto [first, second, candidates] = pairs[i];
    if (i == edge.pair || before.together(first, second) || !after.together(first, second))
      continue;
    pooled.add(evidence.at(i, after.relative(first, second)));
  }
  return pooled;
}

/// Keeps the answers with the highest scores, each once.
void keep_best(std::vector<PlacedGroups>& placements, const SelectionRules& rules) {
  std::stable_sort(placements.begin(), placements.end(),
                   [](const PlacedGroups& x, const PlacedGroups& y) { return x.score > y.score; });
  std::vector<PlacedGroups> kept;
  for (PlacedGroups& placement : placements) {
    if (kept.size() == rules.selection.beam) break;
    const bool is_new = std::none_of(kept.begin(), kept.end(), [&](const PlacedGroups& better) {
      return is_same_answer(placement, better, rules.rivals);
    });
    if (is_new) kept.push_back(std::move(placement));
  }
  placements = std::move(kept);
}

/// The best answers that extend an answer in `beam` by one edge.
std::vector<PlacedGroups> extended(std::span<const PlacedGroups> beam, std::span<const Edge> edges,
                                   std::span<const RigPair> pairs, const SelectionRules& rules,
                                   LoopEvidence& evidence) {
  std::vector<PlacedGroups> next;
  for (const PlacedGroups& before : beam) {
    for (const Edge& edge : edges) {
      const RigPair& pair = pairs[edge.pair];
      if (before.together(pair.first, pair.second)) continue;
      PlacedGroups after = joined(before, pair, edge.evidence->a_from_b);
      const PooledEvidence pooled = pooled_evidence(before, after, pairs, edge, evidence);
      if (!is_strong(*edge.evidence, rules.evidence) && !is_strong(pooled, rules.evidence))
        continue;
      after.score = before.score + pooled.score - rules.evidence.pose_cost;
      next.push_back(std::move(after));
    }
  }
  keep_best(next, rules);
  return next;
}

std::size_t largest_group(const PlacedGroups& placement) {
  std::vector<std::size_t> members(placement.group.size());
  for (const std::size_t group : placement.group) ++members[group];
  return static_cast<std::size_t>(std::max_element(members.begin(), members.end()) -
                                  members.begin());
}

const Eigen::Vector3d kRivalPoint_m(0, 0, 2.5);  // where sensors usually see something

/// Whether two answers put a sensor by the same matches, and therefore mean the same place: those
/// of a pair that has at least an equal share of all of the sensor's.
bool rest_on_same_matches(std::size_t sensor, const PlacedGroups& one, const PlacedGroups& other,
                          std::span<const RigPair> pairs, const RivalOptions& rivals) {
  std::vector<PairCandidates::RestingMatches> of_pairs;
  double all = 0;
  for (const RigPair& pair : pairs) {
    if (pair.first != sensor && pair.second != sensor) continue;
    if (!one.together(pair.first, pair.second) || !other.together(pair.first, pair.second))
      continue;
    of_pairs.push_back(pair.candidates->resting_matches(one.relative(pair.first, pair.second),
                                                        other.relative(pair.first, pair.second)));
    all += of_pairs.back().one;
  }
  return std::ranges::any_of(of_pairs, [&](const PairCandidates::RestingMatches& matches) {
    return matches.common > 0 &&
           matches.common >= rivals.common_matches * std::max(matches.one, matches.other) &&
           matches.one >= rivals.share_of_matches * all / static_cast<double>(of_pairs.size());
  });
}

bool is_rival_of(std::size_t sensor, const PlacedGroups& best, const PlacedGroups& other,
                 std::size_t origin, std::span<const RigPair> pairs, const RivalOptions& rivals) {
  const RigidTransform here = best.relative(origin, sensor), there = other.relative(origin, sensor);
  if (!are_rivals(here, there, rivals)) return false;
  const PoseDifference apart = difference(here, there, kRivalPoint_m);
  if (apart.angle_rad > rivals.same_angle_rad || apart.distance_m > rivals.same_distance_m)
    return true;
  return !rest_on_same_matches(sensor, best, other, pairs, rivals);
}

void measure_margins(std::span<const PlacedGroups> answers, std::span<const RigPair> pairs,
                     const RivalOptions& rivals, PoseSelection& selection) {
  const PlacedGroups& best = selection.best;
  const std::size_t origin = selection.origin;
  selection.margin_to_rival.assign(best.group.size(), kNoRival);
  selection.margin_to_unplaced.assign(best.group.size(), kNoRival);
  for (const PlacedGroups& other : answers) {
    const double behind = best.score - other.score;
    for (std::size_t i = 0; i < best.group.size(); ++i) {
      if (!best.together(i, origin)) continue;
      double& margin = other.together(i, origin) ? selection.margin_to_rival[i]
                                                 : selection.margin_to_unplaced[i];
      if (behind >= margin) continue;
      if (!other.together(i, origin) || is_rival_of(i, best, other, origin, pairs, rivals))
        margin = behind;
    }
  }
}

}  // namespace

PoseSelection select_poses(std::size_t sensors, std::span<const RigPair> pairs,
                           const PoseSelectionOptions& options, const RivalOptions& rivals,
                           const EvidenceOptions& evidence_options) {
  const SelectionRules rules{options, rivals, evidence_options};
  const std::vector<Edge> edges = edges_of(pairs, rules);
  LoopEvidence evidence(pairs, rules);
  std::vector<PlacedGroups> beam = {unplaced_groups(sensors)};
  std::vector<PlacedGroups> answers = beam;
  while (!beam.empty()) {
    beam = extended(beam, edges, pairs, rules, evidence);
    answers.insert(answers.end(), beam.begin(), beam.end());
  }
  PoseSelection selection;
  selection.best = *std::max_element(
      answers.begin(), answers.end(),
      [](const PlacedGroups& x, const PlacedGroups& y) { return x.score < y.score; });
  selection.origin = largest_group(selection.best);
  measure_margins(answers, pairs, rivals, selection);
  return selection;
}

}  // namespace roomcast::alignment
