// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/feature/plane_relief.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace roomcast::alignment {
namespace {

constexpr int kMaxCells = 1024;  // along either axis: 40 m in cells of 4 cm

bool is_near(const Plane& plane, const SurfacePoint& sample, const PlaneReliefOptions& options) {
  return std::abs(plane.height_m(sample.point_m)) <
             options.highest_m + options.highest_per_depth * sample.point_m.z() &&
         sample.normal.dot(plane.normal) > options.min_cosine;
}

}  // namespace

PlaneRelief::PlaneRelief(const Plane& plane, std::span<const SurfacePoint> samples,
                         const PlaneReliefOptions& options)
    : cell_m_(options.cell_m),
      min_samples_(options.min_samples),
      right_(plane.normal.unitOrthogonal()),
      down_(plane.normal.cross(right_)) {
  std::vector<std::pair<Place, float>> heights_m;
  Place last{};
  for (const SurfacePoint& sample : samples) {
    if (!is_near(plane, sample, options)) continue;
    const Place place = place_of(sample.point_m);
    if (heights_m.empty()) first_ = last = place;
    first_ = {std::min(first_.column, place.column), std::min(first_.row, place.row)};
    last = {std::max(last.column, place.column), std::max(last.row, place.row)};
    heights_m.emplace_back(place, plane.height_m(sample.point_m));
  }
  if (heights_m.empty()) return;
  columns_ = std::min(kMaxCells, last.column - first_.column + 1);
  rows_ = std::min(kMaxCells, last.row - first_.row + 1);
  cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (const auto& [place, height_m] : heights_m) {
    const int x = place.column - first_.column, y = place.row - first_.row;
    if (x >= columns_ || y >= rows_) continue;
    Cell& cell = cells_[static_cast<std::size_t>(y * columns_ + x)];
    cell.sum_m += height_m;
    ++cell.count;
  }
}

PlaneRelief::Place PlaneRelief::place_of(const Eigen::Vector3f& point_m) const {
  return {static_cast<int>(std::floor(right_.dot(point_m) / cell_m_)),
          static_cast<int>(std::floor(down_.dot(point_m) / cell_m_))};
}

PlaneRelief::Cell PlaneRelief::around(const Place& place) const {
  const int x = place.column - first_.column, y = place.row - first_.row;
  Cell sum;
  for (int v = std::max(0, y - 1); v <= std::min(rows_ - 1, y + 1); ++v) {
    for (int u = std::max(0, x - 1); u <= std::min(columns_ - 1, x + 1); ++u) {
      const Cell& cell = cells_[static_cast<std::size_t>(v * columns_ + u)];
      sum.sum_m += cell.sum_m;
      sum.count += cell.count;
    }
  }
  return sum;
}

std::optional<float> PlaneRelief::height_m(const Eigen::Vector3f& on_plane_m) const {
  const Cell found = around(place_of(on_plane_m));
  if (found.count < min_samples_) return std::nullopt;
  return found.sum_m / static_cast<float>(found.count);
}

}  // namespace roomcast::alignment
