// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/feature/shape_features.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>

#include <Eigen/Geometry>

namespace roomcast::alignment {
namespace {

constexpr std::size_t kPartners = 3;

using Cell = std::tuple<int, int, int>;

Cell cell_of(const Eigen::Vector3f& point_m, float size_m) {
  const auto along = [&](int axis) { return static_cast<int>(std::floor(point_m(axis) / size_m)); };
  return {along(0), along(1), along(2)};
}

/// The first sample of each cell.
std::vector<SurfacePoint> thinned(std::span<const SurfacePoint> samples, float cell_m) {
  std::map<Cell, SurfacePoint> cells;
  for (const SurfacePoint& sample : samples)
    cells.try_emplace(cell_of(sample.point_m, cell_m), sample);
  std::vector<SurfacePoint> points;
  for (const auto& [cell, point] : cells) points.push_back(point);
  return points;
}

using Neighbours = std::vector<std::vector<std::uint32_t>>;

/// For each point, the other points within the radius.
Neighbours neighbours_of(std::span<const SurfacePoint> points, float radius_m) {
  std::map<Cell, std::vector<std::uint32_t>> cells;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    cells[cell_of(points[i].point_m, radius_m)].push_back(i);
  Neighbours neighbours(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const auto [x, y, z] = cell_of(points[i].point_m, radius_m);
    for (int at = 0; at < 27; ++at) {
      const auto found = cells.find({x + at % 3 - 1, y + at / 3 % 3 - 1, z + at / 9 - 1});
      if (found == cells.end()) continue;
      for (const std::uint32_t j : found->second) {
        const float apart = (points[i].point_m - points[j].point_m).squaredNorm();
        if (i != j && apart < radius_m * radius_m) neighbours[i].push_back(j);
      }
    }
  }
  return neighbours;
}

void count(float value, float least, float most, float* bins) {
  const float part = (value - least) / (most - least);
  const int bin = static_cast<int>(part * static_cast<float>(kShapeBins));
  bins[std::clamp(bin, 0, static_cast<int>(kShapeBins) - 1)] += 1;
}

/// Adds the three angles between two points and their normals, in the frame of the first (Rusu's
/// equation 1; `from` is always the source).
void add_pair(const SurfacePoint& from, const SurfacePoint& to, ShapeHistogram& histogram) {
  const Eigen::Vector3f way = (to.point_m - from.point_m).normalized();
  const Eigen::Vector3f& u = from.normal;
  const Eigen::Vector3f v = way.cross(u).normalized();
  const Eigen::Vector3f w = u.cross(v);
  constexpr float kPi = std::numbers::pi_v<float>;
  count(v.dot(to.normal), -1, 1, histogram.data());
  count(u.dot(way), -1, 1, histogram.data() + kShapeBins);
  count(std::atan2(w.dot(to.normal), u.dot(to.normal)), -kPi, kPi,
        histogram.data() + 2 * kShapeBins);
}

/// Simplified histograms (SPFH): each point with its own neighbours only.
std::vector<ShapeHistogram> simple_histograms(std::span<const SurfacePoint> points,
                                              const Neighbours& neighbours) {
  std::vector<ShapeHistogram> histograms(points.size(), ShapeHistogram{});
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const std::uint32_t j : neighbours[i]) add_pair(points[i], points[j], histograms[i]);
    const float scale = 1 / std::max(1.F, static_cast<float>(neighbours[i].size()));
    for (float& bin : histograms[i]) bin *= scale;
  }
  return histograms;
}

bool surroundings_bend(std::span<const SurfacePoint> points,
                       const std::vector<std::uint32_t>& neighbours, float min_bend) {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (const std::uint32_t j : neighbours) sum += points[j].normal;
  return 1 - sum.norm() / static_cast<float>(neighbours.size()) > min_bend;
}

/// Mean of a point's own histogram and its neighbours', weighted by proximity.
ShapeHistogram full_histogram(std::span<const SurfacePoint> points,
                              const std::vector<ShapeHistogram>& simple,
                              const std::vector<std::uint32_t>& neighbours, std::size_t index,
                              float near_m) {
  ShapeHistogram sum = simple[index];
  float weights = 1;
  for (const std::uint32_t j : neighbours) {
    const float apart = (points[j].point_m - points[index].point_m).norm();
    const float weight = near_m / (near_m + apart) / 4;
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += weight * simple[j][k];
    weights += weight;
  }
  for (float& bin : sum) bin /= weights;
  return sum;
}

float squared_distance(const ShapeHistogram& one, const ShapeHistogram& other) {
  float sum = 0;
  for (std::size_t k = 0; k < one.size(); ++k) sum += (one[k] - other[k]) * (one[k] - other[k]);
  return sum;
}

/// Indices of the kPartners nearest of `others`.
std::vector<std::size_t> nearest(const ShapeFeature& feature,
                                 std::span<const ShapeFeature> others) {
  std::array<std::pair<float, std::size_t>, kPartners> best;
  best.fill({std::numeric_limits<float>::max(), others.size()});
  for (std::size_t j = 0; j < others.size(); ++j) {
    const float distance = squared_distance(feature.histogram, others[j].histogram);
    if (distance >= best.back().first) continue;
    best.back() = {distance, j};
    for (std::size_t k = kPartners - 1; k > 0 && best[k] < best[k - 1]; --k)
      std::swap(best[k], best[k - 1]);
  }
  std::vector<std::size_t> indices;
  for (const auto& [distance, index] : best) {
    if (index < others.size()) indices.push_back(index);
  }
  return indices;
}

}  // namespace

std::vector<ShapeFeature> shape_features(std::span<const SurfacePoint> samples,
                                         const ShapeFeatureOptions& options) {
  const std::vector<SurfacePoint> points = thinned(samples, options.thinning_m);
  const Neighbours neighbours = neighbours_of(points, options.radius_m);
  const std::vector<ShapeHistogram> simple = simple_histograms(points, neighbours);
  std::vector<ShapeFeature> features;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (neighbours[i].size() < options.min_neighbours ||
        !surroundings_bend(points, neighbours[i], options.min_bend))
      continue;
    features.push_back(
        {points[i].point_m, full_histogram(points, simple, neighbours[i], i, options.thinning_m)});
  }
  return features;
}

std::vector<ShapeMatch> match_shapes(std::span<const ShapeFeature> a,
                                     std::span<const ShapeFeature> b) {
  std::vector<std::vector<std::size_t>> of_b;
  for (const ShapeFeature& feature : b) of_b.push_back(nearest(feature, a));
  std::vector<ShapeMatch> matches;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (const std::size_t j : nearest(a[i], b)) {
      if (std::find(of_b[j].begin(), of_b[j].end(), i) != of_b[j].end()) matches.push_back({i, j});
    }
  }
  return matches;
}

}  // namespace roomcast::alignment
