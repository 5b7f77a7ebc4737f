// SPDX-License-Identifier: Apache-2.0
#include "bench/align/fpfh_ransac.h"

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "roomcast/alignment/feature/shape_features.h"
#include "roomcast/alignment/pair/pose_refinement.h"
#include "roomcast/alignment/pair/rigid_fit.h"

namespace roomcast::bench {
namespace {

using alignment::PointMatch;

constexpr int kTrials = 20'000;
constexpr float kInlier_m = 0.09F;  // 1.5 times the point spacing
constexpr float kEdgeRatio = 0.9F;  // minimum ratio of corresponding edge lengths
constexpr std::size_t kMinInliers = 5;

std::vector<PointMatch> shape_matches(const alignment::SensorView& a,
                                      const alignment::SensorView& b) {
  const auto of_a = alignment::shape_features(a.surface.samples);
  const auto of_b = alignment::shape_features(b.surface.samples);
  std::vector<PointMatch> matches;
  for (const alignment::ShapeMatch& match : alignment::match_shapes(of_a, of_b)) {
    matches.push_back({of_a[match.a].point_m, of_b[match.b].point_m, Eigen::Vector2f::Zero(),
                       Eigen::Vector2f::Zero()});
  }
  return matches;
}

bool edges_agree(const std::array<PointMatch, 3>& three) {
  for (std::size_t i = 0; i < 3; ++i) {
    const PointMatch &one = three[i], &other = three[(i + 1) % 3];
    const float in_a = (one.a_m - other.a_m).norm(), in_b = (one.b_m - other.b_m).norm();
    if (!(in_a > kEdgeRatio * in_b && in_b > kEdgeRatio * in_a)) return false;
  }
  return true;
}

std::vector<PointMatch> inliers(const std::vector<PointMatch>& matches,
                                const RigidTransform& a_from_b) {
  const Eigen::Matrix3f rotation = a_from_b.rotation.cast<float>();
  const Eigen::Vector3f shift = a_from_b.translation_m.cast<float>();
  std::vector<PointMatch> agreeing;
  for (const PointMatch& match : matches) {
    if (alignment::distance_m(rotation, shift, match) < kInlier_m) agreeing.push_back(match);
  }
  return agreeing;
}

std::optional<RigidTransform> fitted(std::span<const PointMatch> matches) {
  return alignment::fit_a_from_b(matches, std::vector<float>(matches.size(), 1.F));
}

}  // namespace

std::optional<RigidTransform> fpfh_ransac_pose(const alignment::SensorView& a,
                                               const alignment::SensorView& b) {
  const std::vector<PointMatch> matches = shape_matches(a, b);
  if (matches.size() < kMinInliers) return std::nullopt;
  std::mt19937 random(1);
  std::vector<PointMatch> best;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::array<PointMatch, 3> three;
    for (PointMatch& match : three) match = matches[random() % matches.size()];
    if (!edges_agree(three)) continue;
    const auto pose = fitted(three);
    if (!pose) continue;
    auto agreeing = inliers(matches, *pose);
    if (agreeing.size() > best.size()) best = std::move(agreeing);
  }
  if (best.size() < kMinInliers) return std::nullopt;
  const auto pose = fitted(best);
  if (!pose) return std::nullopt;
  return alignment::refined_pose(a, b, {}, *pose).a_from_b;
}

}  // namespace roomcast::bench
