// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/match_support.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace roomcast::alignment {
namespace {

constexpr std::int64_t kCellsPerAxis = 1 << 16;

std::int64_t cell_of(const Eigen::Vector3f& point_m, float size_m) {
  const auto along = [&](int axis) {
    return static_cast<std::int64_t>(std::floor(point_m(axis) / size_m)) + kCellsPerAxis / 2;
  };
  return (along(0) * kCellsPerAxis + along(1)) * kCellsPerAxis + along(2);
}

}  // namespace

std::vector<PointMatch> agreeing_matches(std::span<const PointMatch> matches,
                                         const RigidTransform& a_from_b, float tolerance_m) {
  const Eigen::Matrix3f rotation = a_from_b.rotation.cast<float>();
  const Eigen::Vector3f shift = a_from_b.translation_m.cast<float>();
  std::vector<PointMatch> agreeing;
  for (const PointMatch& match : matches) {
    if (distance_m(rotation, shift, match) < tolerance_m) agreeing.push_back(match);
  }
  return agreeing;
}

MatchSupport match_support(std::span<const PointMatch> agreeing,
                           const MatchSupportOptions& options) {
  std::vector<std::pair<std::int64_t, float>> weights;
  std::vector<std::int64_t> cells;
  for (const PointMatch& match : agreeing) {
    weights.emplace_back(cell_of(match.b_m, options.weight_cell_m), -match.weight);
    cells.push_back(cell_of(match.b_m, options.count_cell_m));
  }
  std::sort(weights.begin(), weights.end());  // the best match of a cell comes first
  std::sort(cells.begin(), cells.end());
  MatchSupport support;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (i == 0 || weights[i].first != weights[i - 1].first) support.weight -= weights[i].second;
  }
  support.cells = static_cast<int>(std::unique(cells.begin(), cells.end()) - cells.begin());
  return support;
}

}  // namespace roomcast::alignment
