// SPDX-License-Identifier: Apache-2.0
#include "roomcast/model/volume_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "roomcast/core/assert.h"
#include "roomcast/model/cube_cases.h"

namespace roomcast::model {
namespace {

constexpr std::uint32_t kNoPoint = std::numeric_limits<std::uint32_t>::max();

/// An edge of the whole room's grid, and the point on it.
struct EdgePoint {
  std::uint64_t edge = 0;
  std::uint32_t point = 0;
};

/// Two bits for the axis and twenty for each coordinate; kMaxRoom_m and kMinVoxel_m see to it that
/// they fit.
std::uint64_t edge_code(const GridPlace& from, int axis) {
  constexpr std::int32_t kHalf = 1 << 19;
  const auto bits = [](std::int32_t value) { return static_cast<std::uint64_t>(value + kHalf); };
  return bits(from.z) << 42U | bits(from.y) << 22U | bits(from.x) << 2U |
         static_cast<std::uint64_t>(axis);
}

/// Meshes one block after the other.
class BlockMesher {
 public:
  BlockMesher(float voxel_m, RoomMesh& mesh, std::vector<EdgePoint>& shared)
      : voxel_m_(voxel_m), mesh_(mesh), shared_(shared) {}

  void add(const VolumeBlock& block) {
    for (auto& points : points_) points.fill(kNoPoint);
    for (int z = 0; z < kBlockCells; ++z)
      for (int y = 0; y < kBlockCells; ++y)
        for (int x = 0; x < kBlockCells; ++x) add_cell(block, x, y, z);
  }

 private:
  void add_cell(const VolumeBlock& block, int x, int y, int z) {
    const int cube = cube_of_cell(block, x, y, z);
    for (const auto& edges : cube_cases()[static_cast<std::size_t>(cube)]) {
      std::array<std::uint32_t, 3> triangle{};
      std::ranges::transform(edges, triangle.begin(), [&](std::uint8_t edge) {
        const CubeEdge e = cube_edge(edge);
        return point_on(block, x + (e.corner & 1), y + (e.corner >> 1 & 1), z + (e.corner >> 2),
                        e.axis);
      });
      mesh_.triangles.push_back(triangle);
    }
  }

  std::uint32_t point_on(const VolumeBlock& block, int x, int y, int z, int axis) {
    std::uint32_t& point = points_[static_cast<std::size_t>(axis)][VolumeBlock::index(x, y, z)];
    if (point != kNoPoint) return point;
    const std::int16_t from = block.at(x, y, z);
    const std::int16_t to = block.at(x + (axis == 0), y + (axis == 1), z + (axis == 2));
    const GridPlace corner = {kBlockCells * block.place.x + x, kBlockCells * block.place.y + y,
                              kBlockCells * block.place.z + z};
    Eigen::Vector3f at(static_cast<float>(corner.x), static_cast<float>(corner.y),
                       static_cast<float>(corner.z));
    at[axis] += crossing(from, to);
    point = static_cast<std::uint32_t>(mesh_.points_m.size());
    mesh_.points_m.push_back(voxel_m_ * at);
    const auto on_side = [&](int value, int of_axis) {
      return axis != of_axis && (value == 0 || value == kBlockCells);
    };
    if (on_side(x, 0) || on_side(y, 1) || on_side(z, 2))
      shared_.push_back({edge_code(corner, axis), point});
    return point;
  }

  float voxel_m_;
  RoomMesh& mesh_;
  std::vector<EdgePoint>& shared_;
  std::array<std::array<std::uint32_t, kBlockCorners * kBlockCorners * kBlockCorners>, 3> points_{};
};

/// Lets all triangles use the first of the points on an edge that several blocks share.
void weld(std::vector<EdgePoint>& shared, RoomMesh& mesh) {
  std::ranges::sort(shared, [](const EdgePoint& a, const EdgePoint& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.point < b.point;
  });
  std::vector<std::uint32_t> same_as(mesh.points_m.size());
  for (std::uint32_t i = 0; i < same_as.size(); ++i) same_as[i] = i;
  for (std::size_t i = 1; i < shared.size(); ++i)
    if (shared[i].edge == shared[i - 1].edge)
      same_as[shared[i].point] = same_as[shared[i - 1].point];
  for (auto& triangle : mesh.triangles)
    for (std::uint32_t& point : triangle) point = same_as[point];
}

/// Rounds each corner of a triangle that has shrunk to a line or a point away.
void drop_degenerate(RoomMesh& mesh) {
  std::erase_if(mesh.triangles,
                [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
}

Rgb8 mixed_color(std::span<const ViewSurface> views, std::span<const Eigen::Vector3f> gains,
                 const Eigen::Vector3f& at_m, float tolerance_m) {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  float weights = 0;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const auto colored = views[i].color(at_m, tolerance_m);
    if (!colored) continue;
    const float square = colored->quality * colored->quality, weight = square * square;
    sum += weight * colored->color.cwiseProduct(gains[i]);
    weights += weight;
  }
  if (!(weights > 0)) return kNoColor;
  const auto level = [&](int i) {
    return static_cast<std::uint8_t>(std::clamp(std::lround(sum[i] / weights), 0L, 255L));
  };
  return {level(0), level(1), level(2)};
}

}  // namespace

RoomMesh mesh_volume(const RoomVolume& volume) {
  RoomMesh mesh;
  std::vector<EdgePoint> shared;
  BlockMesher mesher(volume.voxel_m, mesh, shared);
  for (const VolumeBlock& block : volume.blocks) mesher.add(block);
  weld(shared, mesh);
  drop_degenerate(mesh);
  remove_small_parts(1, mesh);
  return mesh;
}

void color_mesh(std::span<const ViewSurface> views, std::span<const Eigen::Vector3f> gains,
                const ModelOptions& options, const Workers& workers, RoomMesh& mesh) {
  ROOMCAST_ASSERT(gains.size() == views.size());
  mesh.colors.assign(mesh.points_m.size(), kNoColor);
  const float tolerance_m = options.truncation_voxels * options.voxel_m;
  constexpr std::size_t kAtATime = 4096;
  const auto rows = static_cast<int>((mesh.points_m.size() + kAtATime - 1) / kAtATime);
  for_each_row(rows, workers, [&](int row) {
    const std::size_t begin = static_cast<std::size_t>(row) * kAtATime;
    const std::size_t end = std::min(begin + kAtATime, mesh.points_m.size());
    for (std::size_t i = begin; i < end; ++i)
      mesh.colors[i] = mixed_color(views, gains, mesh.points_m[i], tolerance_m);
  });
}

void remove_uncolored(RoomMesh& mesh) {
  std::erase_if(mesh.triangles, [&](const auto& triangle) {
    return std::ranges::any_of(triangle,
                               [&](std::uint32_t point) { return mesh.colors[point] == kNoColor; });
  });
  remove_small_parts(1, mesh);
}

}  // namespace roomcast::model
