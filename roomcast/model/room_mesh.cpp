// SPDX-License-Identifier: Apache-2.0
#include "roomcast/model/room_mesh.h"

#include <limits>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

namespace roomcast::model {
namespace {

/// Sets of points that triangles connect (union-find with path halving).
class Parts {
 public:
  explicit Parts(std::size_t points) : parents_(points) {
    std::iota(parents_.begin(), parents_.end(), 0U);
  }
  std::uint32_t root(std::uint32_t point) {
    while (parents_[point] != point) point = parents_[point] = parents_[parents_[point]];
    return point;
  }
  void connect(std::uint32_t a, std::uint32_t b) { parents_[root(a)] = root(b); }

 private:
  std::vector<std::uint32_t> parents_;
};

}  // namespace

std::vector<Eigen::Vector3f> point_normals(const RoomMesh& mesh) {
  std::vector<Eigen::Vector3f> normals(mesh.points_m.size(), Eigen::Vector3f::Zero());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3f& corner = mesh.points_m[a];
    const Eigen::Vector3f normal = (mesh.points_m[b] - corner).cross(mesh.points_m[c] - corner);
    for (const std::uint32_t point : {a, b, c}) normals[point] += normal;
  }
  for (Eigen::Vector3f& normal : normals) {
    const float length = normal.norm();
    normal = length > 0 ? Eigen::Vector3f(normal / length) : Eigen::Vector3f::UnitY().eval();
  }
  return normals;
}

void remove_small_parts(int min_triangles, RoomMesh& mesh) {
  Parts parts(mesh.points_m.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    parts.connect(a, b);
    parts.connect(b, c);
  }
  std::vector<int> sizes(mesh.points_m.size());
  for (const auto& triangle : mesh.triangles) ++sizes[parts.root(triangle[0])];
  std::erase_if(mesh.triangles, [&](const auto& triangle) {
    return sizes[parts.root(triangle[0])] < min_triangles;
  });
  constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> new_number(mesh.points_m.size(), kUnused);
  const bool colored = !mesh.colors.empty();
  RoomMesh kept;
  for (auto& triangle : mesh.triangles) {
    for (std::uint32_t& point : triangle) {
      std::uint32_t& number = new_number[point];
      if (number == kUnused) {
        number = static_cast<std::uint32_t>(kept.points_m.size());
        kept.points_m.push_back(mesh.points_m[point]);
        if (colored) kept.colors.push_back(mesh.colors[point]);
      }
      point = number;
    }
  }
  kept.triangles = std::move(mesh.triangles);
  mesh = std::move(kept);
}

}  // namespace roomcast::model
