// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/people/surface_net.h"

#include <cmath>

namespace roomcast::simulator {
namespace {

using Eigen::Vector3f;
using Eigen::Vector3i;

constexpr std::uint32_t kNoVertex = ~0U;

/// Distances at the corners of a grid around the solid.
class Grid {
 public:
  Grid(const Solid& solid, float cell_m) : cell_m_(cell_m) {
    const Eigen::AlignedBox3f box = solid.box();
    low_ = box.min() - Vector3f::Constant(1.5F * cell_m);
    const Vector3f size = (box.max() - low_) / cell_m;
    corners_ = (size.array().ceil() + 2.0F).matrix().cast<int>();
    distances_.resize(static_cast<std::size_t>(corners_.prod()));
    for (int z = 0; z < corners_.z(); ++z)
      for (int y = 0; y < corners_.y(); ++y)
        for (int x = 0; x < corners_.x(); ++x)
          distances_[index({x, y, z})] = solid.distance(point(Vector3i(x, y, z).cast<float>()));
  }

  [[nodiscard]] const Vector3i& corners() const { return corners_; }
  [[nodiscard]] std::size_t index(const Vector3i& at) const {
    return static_cast<std::size_t>((at.z() * corners_.y() + at.y()) * corners_.x() + at.x());
  }
  [[nodiscard]] float at(const Vector3i& corner) const { return distances_[index(corner)]; }
  [[nodiscard]] Vector3f point(const Vector3f& corner) const { return low_ + cell_m_ * corner; }

 private:
  float cell_m_;
  Vector3f low_;
  Vector3i corners_;
  std::vector<float> distances_;
};

Vector3i corner_of(const Vector3i& cell, int number) {
  return cell + Vector3i(number & 1, (number >> 1) & 1, number >> 2);
}

/// Mean of the points at which the surface crosses the edges of a cell; false if it does not.
bool crossing(const Grid& grid, const Vector3i& cell, Vector3f& mean) {
  Vector3f sum = Vector3f::Zero();
  int count = 0;
  for (int a = 0; a < 8; ++a) {
    for (int axis = 0; axis < 3; ++axis) {
      const int b = a | (1 << axis);
      if (a == b) continue;
      const float da = grid.at(corner_of(cell, a));
      const float db = grid.at(corner_of(cell, b));
      if ((da < 0.0F) == (db < 0.0F)) continue;
      sum += corner_of(cell, a).cast<float>() + da / (da - db) * Vector3f::Unit(axis);
      ++count;
    }
  }
  if (count == 0) return false;
  mean = grid.point(sum / static_cast<float>(count));
  return true;
}

/// Moves a vertex onto the surface along the gradient of the distance.
Vector3f settled(const Solid& solid, Vector3f at, float cell_m) {
  for (int i = 0; i < 2; ++i) {
    const float away = std::clamp(solid.distance(at), -0.5F * cell_m, 0.5F * cell_m);
    at -= away * solid.outward(at);
  }
  return at;
}

}  // namespace

SurfaceNet surface_net(const Solid& solid, float cell_m) {
  const Grid grid(solid, cell_m);
  const Vector3i cells = grid.corners() - Vector3i::Ones();
  std::vector<std::uint32_t> vertex_of(static_cast<std::size_t>(grid.corners().prod()), kNoVertex);
  SurfaceNet net;
  Vector3f mean;
  for (int z = 0; z < cells.z(); ++z) {
    for (int y = 0; y < cells.y(); ++y) {
      for (int x = 0; x < cells.x(); ++x) {
        if (!crossing(grid, {x, y, z}, mean)) continue;
        vertex_of[grid.index({x, y, z})] = static_cast<std::uint32_t>(net.positions.size());
        net.positions.push_back(settled(solid, mean, cell_m));
      }
    }
  }
  for (int z = 1; z < cells.z(); ++z) {
    for (int y = 1; y < cells.y(); ++y) {
      for (int x = 1; x < cells.x(); ++x) {
        const Vector3i at(x, y, z);
        for (int axis = 0; axis < 3; ++axis) {
          const bool in = grid.at(at) < 0.0F;
          const bool in_next = grid.at(at + Vector3i::Unit(axis)) < 0.0F;
          if (in == in_next) continue;
          // The four cells around the edge from `at` along the axis, counter-clockwise about it.
          const Vector3i u = Vector3i::Unit((axis + 1) % 3);
          const Vector3i v = Vector3i::Unit((axis + 2) % 3);
          std::array<std::uint32_t, 4> quad = {
              vertex_of[grid.index(at - u - v)], vertex_of[grid.index(at - v)],
              vertex_of[grid.index(at)], vertex_of[grid.index(at - u)]};
          if (in_next) std::swap(quad[1], quad[3]);
          net.quads.push_back(quad);
        }
      }
    }
  }
  return net;
}

}  // namespace roomcast::simulator
