// SPDX-License-Identifier: Apache-2.0
#include "roomcast/model/spread_color.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "roomcast/core/assert.h"
#include "roomcast/model/volume_mesh.h"

namespace roomcast::model {
namespace {

constexpr int kSmoothings = 16;  // of what was spread, which would have rays otherwise

struct SpreadPoint {
  Eigen::Vector3f level = Eigen::Vector3f::Zero();
  bool is_known = false;
};

/// The neighbours of each point that is to be coloured, one after the other.
class Neighbours {
 public:
  Neighbours(const RoomMesh& mesh, const std::vector<std::uint32_t>& points)
      : begins_(points.size() + 1), number_(mesh.points_m.size(), kNotWanted) {
    for (std::uint32_t i = 0; i < points.size(); ++i) number_[points[i]] = i;
    for_each_edge(mesh, [&](std::uint32_t i, std::uint32_t) { ++begins_[i + 1]; });
    for (std::size_t i = 1; i < begins_.size(); ++i) begins_[i] += begins_[i - 1];
    others_.resize(begins_.back());
    std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
    for_each_edge(mesh, [&](std::uint32_t i, std::uint32_t other) { others_[next[i]++] = other; });
  }

  /// The mean of those that are known.
  [[nodiscard]] SpreadPoint mean(std::uint32_t i, const std::vector<SpreadPoint>& all) const {
    SpreadPoint mean;
    float count = 0;
    for (std::uint32_t at = begins_[i]; at < begins_[i + 1]; ++at) {
      const SpreadPoint& other = all[others_[at]];
      if (!other.is_known) continue;
      mean.level += other.level;
      count += 1;
    }
    mean.is_known = count > 0;
    if (mean.is_known) mean.level /= count;
    return mean;
  }

 private:
  static constexpr std::uint32_t kNotWanted = 0xFFFF'FFFF;

  template <class Edge>
  void for_each_edge(const RoomMesh& mesh, Edge edge) {
    for (const auto& triangle : mesh.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t from = number_[triangle[i]];
        if (from == kNotWanted) continue;
        edge(from, triangle[(i + 1) % 3]);
        edge(from, triangle[(i + 2) % 3]);
      }
    }
  }

  std::vector<std::uint32_t> begins_, number_, others_;
};

}  // namespace

void spread_color(RoomMesh& mesh) {
  ROOMCAST_ASSERT(mesh.colors.size() == mesh.points_m.size());
  std::vector<SpreadPoint> all(mesh.points_m.size());
  std::vector<std::uint32_t> bare;
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    const Rgb8 color = mesh.colors[i];
    all[i] = {{float(color.r), float(color.g), float(color.b)}, color != kNoColor};
    if (!all[i].is_known) bare.push_back(i);
  }
  if (bare.empty() || bare.size() == all.size()) return;
  const Neighbours neighbours(mesh, bare);
  const auto step = [&](bool only_unknown) {
    std::vector<std::pair<std::uint32_t, SpreadPoint>> found;
    for (std::uint32_t i = 0; i < bare.size(); ++i) {
      if (only_unknown == all[bare[i]].is_known) continue;
      const SpreadPoint mean = neighbours.mean(i, all);
      if (mean.is_known) found.emplace_back(bare[i], mean);
    }
    for (const auto& [point, color] : found) all[point] = color;
    return !found.empty();
  };
  while (step(true)) {
  }
  for (int i = 0; i < kSmoothings; ++i) step(false);
  for (const std::uint32_t point : bare) {
    if (!all[point].is_known) continue;
    const auto level = [&](int i) {
      return static_cast<std::uint8_t>(std::clamp(std::lround(all[point].level[i]), 0L, 255L));
    };
    mesh.colors[point] = {level(0), level(1), level(2)};
  }
}

}  // namespace roomcast::model
