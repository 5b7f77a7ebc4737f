// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/board/board_match.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "roomcast/alignment/pair/pair_equations.h"
#include "roomcast/alignment/pair/rigid_fit.h"

namespace roomcast::alignment {
namespace {

constexpr double kMaxSightingGap_s = 0.35;  // between sightings of b, to be joined by a line
constexpr double kMaxMotion_m = 0.06;       // of a corner during the gap: held roughly still
constexpr double kAnotherPlace_m = 0.15;
constexpr double kMaxCornerDistance_m = 0.05;
constexpr std::size_t kMinPlaces = 4;
constexpr double kMinSpread_m = 0.3;     // of the places, root mean square
constexpr double kCornerSigma_m = 0.01;  // of depth on a tag, common to its corners
constexpr double kMaxBoardError_mm = 40;

/// The pose of the tag at one time, seen by both.
struct Pose {
  double time_s;
  int tag;
  std::array<Eigen::Vector3d, 4> a_m, b_m;
};

Eigen::Vector3d middle(const std::array<Eigen::Vector3d, 4>& corners) {
  return 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
}

/// The corners as b would have seen them at that time (interpolated).
std::optional<std::array<Eigen::Vector3d, 4>> seen_at(std::span<const TagSighting> b, int tag,
                                                      double time_s) {
  const TagSighting *before = nullptr, *after = nullptr;
  for (const TagSighting& sighting : b) {
    if (sighting.tag != tag) continue;
    if (sighting.time_s <= time_s) before = &sighting;
    if (sighting.time_s >= time_s && after == nullptr) after = &sighting;
  }
  if (before == nullptr || after == nullptr) return std::nullopt;
  const double gap_s = after->time_s - before->time_s;
  if (gap_s > kMaxSightingGap_s) return std::nullopt;
  const double part = gap_s > 0 ? (time_s - before->time_s) / gap_s : 0;
  std::array<Eigen::Vector3d, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d step = after->corners_m[i] - before->corners_m[i];
    if (step.norm() > kMaxMotion_m) return std::nullopt;
    corners[i] = before->corners_m[i] + part * step;
  }
  return corners;
}

std::vector<Pose> common_poses(std::span<const TagSighting> a, std::span<const TagSighting> b) {
  std::vector<Pose> poses;
  for (const TagSighting& sighting : a) {
    if (const auto there = seen_at(b, sighting.tag, sighting.time_s))
      poses.push_back({sighting.time_s, sighting.tag, sighting.corners_m, *there});
  }
  return poses;
}

std::optional<RigidTransform> fit(std::span<const Pose* const> poses) {
  std::vector<PointMatch> matches;
  for (const Pose* pose : poses) {
    for (std::size_t i = 0; i < 4; ++i) {
      PointMatch& match = matches.emplace_back();
      match.a_m = pose->a_m[i].cast<float>();
      match.b_m = pose->b_m[i].cast<float>();
    }
  }
  return fit_a_from_b(matches, std::vector<float>(matches.size(), 1.F));
}

std::vector<const Pose*> agreeing(std::span<const Pose> poses, const RigidTransform& a_from_b) {
  std::vector<const Pose*> agree;
  for (const Pose& pose : poses) {
    double worst = 0;
    for (std::size_t i = 0; i < 4; ++i)
      worst = std::max(worst, (a_from_b * pose.b_m[i] - pose.a_m[i]).norm());
    if (worst < kMaxCornerDistance_m) agree.push_back(&pose);
  }
  return agree;
}

/// The number of places at which the tag was held, and how far apart they are.
struct Places {
  std::size_t count = 0;
  double spread_m = 0;
};
Places places_of(std::span<const Pose* const> poses) {
  std::vector<Eigen::Vector3d> places;
  for (const Pose* pose : poses) {
    const Eigen::Vector3d at = middle(pose->b_m);
    const bool known = std::ranges::any_of(
        places, [&](const auto& place) { return (place - at).norm() < kAnotherPlace_m; });
    if (!known) places.push_back(at);
  }
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& place : places) mean += place / static_cast<double>(places.size());
  double squares = 0;
  for (const auto& place : places) squares += (place - mean).squaredNorm();
  return {places.size(),
          std::sqrt(squares / std::max<double>(1, static_cast<double>(places.size())))};
}

/// Standard deviation 2.5 m in front of b. Each place counts once, however long the tag was held
/// there.
double expected_error_ahead_m(std::span<const Pose* const> poses, const RigidTransform& a_from_b,
                              const Places& places) {
  Matrix6 information = Matrix6::Zero();
  const double weight = static_cast<double>(places.count) / static_cast<double>(poses.size()) /
                        (2 * kCornerSigma_m * kCornerSigma_m);
  for (const Pose* pose : poses) {
    const Eigen::Matrix<double, 3, 6> by = point_motion(a_from_b * middle(pose->b_m));
    information += weight * by.transpose() * by;
  }
  information += 1e-6 * Matrix6::Identity();
  return expected_error_m(information, a_from_b * Eigen::Vector3d(0, 0, 2.5));
}

}  // namespace

Result<BoardMatch> match_boards(std::span<const TagSighting> a, std::span<const TagSighting> b) {
  const auto poses = common_poses(a, b);
  if (poses.empty())
    return unavailable("no board was held still in its view and another sensor's yet");
  std::vector<const Pose*> best;
  constexpr std::size_t kTried = 40;
  const std::size_t step = std::max<std::size_t>(1, poses.size() / kTried);
  for (std::size_t i = 0; i < poses.size(); i += step) {
    for (std::size_t j = i + step; j < poses.size(); j += step) {
      const std::array two = {&poses[i], &poses[j]};
      if ((middle(two[0]->b_m) - middle(two[1]->b_m)).norm() < kAnotherPlace_m) continue;
      const auto hypothesis = fit(two);
      if (!hypothesis) continue;
      auto agree = agreeing(poses, *hypothesis);
      if (agree.size() > best.size()) best = std::move(agree);
    }
  }
  RigidTransform a_from_b;
  for (int round = 0; round < 3; ++round) {
    const auto better = best.size() < 2 ? std::nullopt : fit(best);
    if (!better) return unavailable("hold the board still at four places or more, well apart");
    a_from_b = *better;
    best = agreeing(poses, a_from_b);
  }
  const Places places = places_of(best);
  if (places.count < kMinPlaces || places.spread_m < kMinSpread_m)
    return unavailable("hold the board still at four places or more, well apart");
  if (2 * best.size() < poses.size())
    return unavailable("the board's places do not fit together; use a single, flat board");
  const BoardMatch match{a_from_b, 1000 * expected_error_ahead_m(best, a_from_b, places),
                         static_cast<int>(best.size())};
  if (match.expected_error_mm > kMaxBoardError_mm)
    return unavailable(
        "the board's places were too close together; hold it nearer and further away");
  return match;
}

}  // namespace roomcast::alignment
