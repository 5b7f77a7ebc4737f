// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/spatial_vote.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>

#include "roomcast/alignment/pair/pose_difference.h"

namespace roomcast::alignment {
namespace {

std::vector<PointMatch> heaviest(std::span<const PointMatch> matches, std::size_t most) {
  std::vector<PointMatch> chosen(matches.begin(), matches.end());
  std::stable_sort(chosen.begin(), chosen.end(),
                   [](const PointMatch& x, const PointMatch& y) { return x.weight > y.weight; });
  if (chosen.size() > most) chosen.resize(most);
  return chosen;
}

/// Limits of compatible matches, apart from the options: read for a million pairs of matches.
struct Compatibility {
  float tolerance_m, tolerance_per_metre, min_apart_m;
};

bool are_compatible(const PointMatch& one, const PointMatch& other, const Compatibility& limits) {
  const float in_a = (one.a_m - other.a_m).norm(), in_b = (one.b_m - other.b_m).norm();
  return in_a > limits.min_apart_m && in_b > limits.min_apart_m &&
         std::abs(in_a - in_b) <
             limits.tolerance_m + limits.tolerance_per_metre * 0.5F * (in_a + in_b);
}

using Neighbours = std::vector<std::vector<std::uint32_t>>;

Neighbours compatible_neighbours(std::span<const PointMatch> matches, const VoteOptions& options) {
  const Compatibility limits{options.tolerance_m, options.tolerance_per_metre, options.min_apart_m};
  Neighbours neighbours(matches.size());
  for (std::uint32_t i = 0; i < matches.size(); ++i) {
    for (std::uint32_t j = i + 1; j < matches.size(); ++j) {
      if (!are_compatible(matches[i], matches[j], limits)) continue;
      neighbours[i].push_back(j);
      neighbours[j].push_back(i);
    }
  }
  return neighbours;
}

/// Votes for every compatible pair of matches, from the matches compatible with both.
class SecondOrderVotes {
 public:
  SecondOrderVotes(std::span<const PointMatch> matches, const Neighbours& neighbours)
      : count_(matches.size()), votes_(count_ * count_) {
    std::vector<float> common(count_);
    for (std::size_t i = 0; i < count_; ++i) {
      std::fill(common.begin(), common.end(), 0.F);
      for (const std::uint32_t k : neighbours[i]) {
        for (const std::uint32_t j : neighbours[k]) common[j] += matches[k].weight;
      }
      for (const std::uint32_t j : neighbours[i]) {
        votes_[i * count_ + j] = std::sqrt(matches[i].weight * matches[j].weight) * common[j];
      }
    }
  }

  [[nodiscard]] std::span<const float> of(std::size_t match) const {
    return {votes_.data() + match * count_, count_};
  }
  [[nodiscard]] float total(std::size_t match) const {
    const auto row = of(match);
    return std::accumulate(row.begin(), row.end(), 0.F);
  }

 private:
  std::size_t count_;
  std::vector<float> votes_;
};

template <class Key>
std::vector<std::uint32_t> descending(std::size_t count, Key key) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t x, std::uint32_t y) { return key(x) > key(y); });
  return order;
}

/// A pose fitted to the seed and the neighbours with most votes for it.
std::optional<RigidTransform> pose_of_seed(std::span<const PointMatch> matches,
                                           std::span<const float> votes, std::uint32_t seed,
                                           std::vector<std::uint32_t> neighbours,
                                           std::size_t max_neighbours) {
  const std::size_t kept = std::min(max_neighbours, neighbours.size());
  std::partial_sort(neighbours.begin(), neighbours.begin() + static_cast<std::ptrdiff_t>(kept),
                    neighbours.end(), [&](std::uint32_t x, std::uint32_t y) {
                      return votes[x] != votes[y] ? votes[x] > votes[y] : x < y;
                    });
  neighbours.resize(kept);
  std::vector<PointMatch> chosen = {matches[seed]};
  std::vector<float> weights = {0};
  for (const std::uint32_t neighbour : neighbours) {
    if (!(votes[neighbour] > 0)) continue;
    chosen.push_back(matches[neighbour]);
    weights.push_back(votes[neighbour]);
  }
  weights[0] = *std::max_element(weights.begin(), weights.end());
  if (chosen.size() < 4) return std::nullopt;
  return fit_a_from_b(chosen, weights);
}

/// Refits several times to all matches that agree, with soft weights.
std::optional<RigidTransform> settled(std::span<const PointMatch> matches, RigidTransform pose,
                                      const VoteOptions& options) {
  const float inlier_m = options.inlier_m, softening_m = options.softening_m;
  std::vector<float> weights(matches.size());
  for (int i = 0; i < options.seed_refinements; ++i) {
    const Eigen::Matrix3f rotation = pose.rotation.cast<float>();
    const Eigen::Vector3f shift = pose.translation_m.cast<float>();
    for (std::size_t m = 0; m < matches.size(); ++m) {
      const float away_m = distance_m(rotation, shift, matches[m]);
      weights[m] = away_m < inlier_m ? matches[m].weight / (softening_m + away_m) : 0;
    }
    const auto fitted = fit_a_from_b(matches, weights);
    if (!fitted) return std::nullopt;
    pose = *fitted;
  }
  return pose;
}

bool is_new(const PoseHypothesis& candidate, std::span<const PoseHypothesis> known,
            const VoteOptions& options) {
  return std::none_of(known.begin(), known.end(), [&](const PoseHypothesis& other) {
    const PoseDifference apart = difference(candidate.a_from_b, other.a_from_b);
    return apart.angle_rad < options.same_angle_rad && apart.distance_m < options.same_distance_m;
  });
}

std::vector<PoseHypothesis> most_supported(std::vector<PoseHypothesis> found,
                                           const VoteOptions& options) {
  std::stable_sort(
      found.begin(), found.end(),
      [](const PoseHypothesis& x, const PoseHypothesis& y) { return x.support > y.support; });
  std::vector<PoseHypothesis> kept;
  for (const PoseHypothesis& hypothesis : found) {
    if (kept.size() == options.max_hypotheses || hypothesis.support < options.min_support) break;
    if (is_new(hypothesis, kept, options)) kept.push_back(hypothesis);
  }
  return kept;
}

}  // namespace

std::vector<PoseHypothesis> vote_for_poses(std::span<const PointMatch> all,
                                           const VoteOptions& options,
                                           const MatchSupportOptions& support) {
  const std::vector<PointMatch> matches = heaviest(all, options.max_matches);
  const Neighbours neighbours = compatible_neighbours(matches, options);
  const SecondOrderVotes votes(matches, neighbours);
  std::vector<float> totals(matches.size());
  for (std::size_t i = 0; i < matches.size(); ++i) totals[i] = votes.total(i);
  std::vector<bool> explained(matches.size());
  std::vector<PoseHypothesis> found;
  for (const std::uint32_t seed :
       descending(matches.size(), [&](std::uint32_t i) { return totals[i]; })) {
    if (found.size() == options.max_seeds || !(totals[seed] > 0)) break;
    if (explained[seed]) continue;
    explained[seed] = true;
    const auto start =
        pose_of_seed(matches, votes.of(seed), seed, neighbours[seed], options.seed_neighbours);
    if (!start) continue;
    const auto pose = settled(matches, *start, options);
    if (!pose) continue;
    const Eigen::Matrix3f rotation = pose->rotation.cast<float>();
    const Eigen::Vector3f shift = pose->translation_m.cast<float>();
    for (std::size_t i = 0; i < matches.size(); ++i) {
      if (distance_m(rotation, shift, matches[i]) < options.inlier_m) explained[i] = true;
    }
    const auto agreeing = agreeing_matches(matches, *pose, options.inlier_m);
    found.push_back({*pose, match_support(agreeing, support).weight});
  }
  return most_supported(std::move(found), options);
}

}  // namespace roomcast::alignment
