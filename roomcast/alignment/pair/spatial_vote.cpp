// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/spatial_vote.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <optional>

#include "roomcast/alignment/pair/match_support.h"
#include "roomcast/alignment/pair/pose_difference.h"

namespace roomcast::alignment {
namespace {

constexpr float kTolerancePerMetre = 0.012F;
constexpr float kMinApart_m = 0.06F;  // nearer points do not constrain rotation
constexpr std::size_t kSeedNeighbours = 25;
constexpr int kSeedRefinements = 4;
constexpr float kSoftening_m = 0.02F;  // residual at which a match still has half its weight
constexpr double kMinSupport = 1.5;
constexpr double kSameAngle_rad = 3 * std::numbers::pi / 180, kSameDistance_m = 0.15;

std::vector<PointMatch> heaviest(std::span<const PointMatch> matches, std::size_t most) {
  std::vector<PointMatch> chosen(matches.begin(), matches.end());
  std::stable_sort(chosen.begin(), chosen.end(),
                   [](const PointMatch& x, const PointMatch& y) { return x.weight > y.weight; });
  if (chosen.size() > most) chosen.resize(most);
  return chosen;
}

bool are_compatible(const PointMatch& one, const PointMatch& other, float tolerance_m) {
  const float in_a = (one.a_m - other.a_m).norm(), in_b = (one.b_m - other.b_m).norm();
  return in_a > kMinApart_m && in_b > kMinApart_m &&
         std::abs(in_a - in_b) < tolerance_m + kTolerancePerMetre * 0.5F * (in_a + in_b);
}

using Neighbours = std::vector<std::vector<std::uint32_t>>;

Neighbours compatible_neighbours(std::span<const PointMatch> matches, float tolerance_m) {
  Neighbours neighbours(matches.size());
  for (std::uint32_t i = 0; i < matches.size(); ++i) {
    for (std::uint32_t j = i + 1; j < matches.size(); ++j) {
      if (!are_compatible(matches[i], matches[j], tolerance_m)) continue;
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
                                           std::vector<std::uint32_t> neighbours) {
  const std::size_t kept = std::min(kSeedNeighbours, neighbours.size());
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

/// Refits kSeedRefinements times to all matches that agree, with soft weights.
std::optional<RigidTransform> settled(std::span<const PointMatch> matches, RigidTransform pose,
                                      float inlier_m) {
  std::vector<float> weights(matches.size());
  for (int i = 0; i < kSeedRefinements; ++i) {
    const Eigen::Matrix3f rotation = pose.rotation.cast<float>();
    const Eigen::Vector3f shift = pose.translation_m.cast<float>();
    for (std::size_t m = 0; m < matches.size(); ++m) {
      const float away_m = distance_m(rotation, shift, matches[m]);
      weights[m] = away_m < inlier_m ? matches[m].weight / (kSoftening_m + away_m) : 0;
    }
    const auto fitted = fit_a_from_b(matches, weights);
    if (!fitted) return std::nullopt;
    pose = *fitted;
  }
  return pose;
}

bool is_new(const PoseHypothesis& candidate, std::span<const PoseHypothesis> known) {
  return std::none_of(known.begin(), known.end(), [&](const PoseHypothesis& other) {
    const PoseDifference apart = difference(candidate.a_from_b, other.a_from_b);
    return apart.angle_rad < kSameAngle_rad && apart.distance_m < kSameDistance_m;
  });
}

std::vector<PoseHypothesis> most_supported(std::vector<PoseHypothesis> found, std::size_t most) {
  std::stable_sort(
      found.begin(), found.end(),
      [](const PoseHypothesis& x, const PoseHypothesis& y) { return x.support > y.support; });
  std::vector<PoseHypothesis> kept;
  for (const PoseHypothesis& hypothesis : found) {
    if (kept.size() == most || hypothesis.support < kMinSupport) break;
    if (is_new(hypothesis, kept)) kept.push_back(hypothesis);
  }
  return kept;
}

}  // namespace

std::vector<PoseHypothesis> vote_for_poses(std::span<const PointMatch> all,
                                           const VoteOptions& options) {
  const std::vector<PointMatch> matches = heaviest(all, options.max_matches);
  const Neighbours neighbours = compatible_neighbours(matches, options.tolerance_m);
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
    const auto start = pose_of_seed(matches, votes.of(seed), seed, neighbours[seed]);
    if (!start) continue;
    const auto pose = settled(matches, *start, options.inlier_m);
    if (!pose) continue;
    const Eigen::Matrix3f rotation = pose->rotation.cast<float>();
    const Eigen::Vector3f shift = pose->translation_m.cast<float>();
    for (std::size_t i = 0; i < matches.size(); ++i) {
      if (distance_m(rotation, shift, matches[i]) < options.inlier_m) explained[i] = true;
    }
    const auto agreeing = agreeing_matches(matches, *pose, options.inlier_m);
    found.push_back({*pose, match_support(agreeing).weight});
  }
  return most_supported(std::move(found), options.max_hypotheses);
}

}  // namespace roomcast::alignment
