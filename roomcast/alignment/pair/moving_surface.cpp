// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/moving_surface.h"

#include <array>
#include <cmath>
#include <optional>

#include "roomcast/geometry/dense_solvers.h"

namespace roomcast::alignment {
namespace {

Eigen::Vector3f block_point(const SensorView& view, const DepthInstant& instant, int x, int y) {
  const float z_m = 0.001F * static_cast<float>(instant.depth_mm.at(x, y));
  return z_m * view.block_rays.at(x, y).homogeneous();
}

/// The moving blocks around a block that are on its surface.
struct Neighbours {
  std::array<Eigen::Vector3f, 9> points_m;
  int count = 0;

  Neighbours(const SensorView& view, const DepthInstant& instant, int x, int y,
             float same_surface_m) {
    const float z_m = block_point(view, instant, x, y).z();
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if (instant.moving.at(x + dx, y + dy) == 0) continue;
        const Eigen::Vector3f point = block_point(view, instant, x + dx, y + dy);
        if (point.z() > 0 && std::abs(point.z() - z_m) <= same_surface_m)
          points_m[static_cast<std::size_t>(count++)] = point;
      }
    }
  }
  [[nodiscard]] Eigen::Vector3f middle() const {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (int i = 0; i < count; ++i) sum += points_m[static_cast<std::size_t>(i)];
    return sum / static_cast<float>(count);
  }
  [[nodiscard]] Eigen::Vector3f normal(const Eigen::Vector3f& middle_m) const {
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    for (int i = 0; i < count; ++i) {
      const Eigen::Vector3d apart =
          (points_m[static_cast<std::size_t>(i)] - middle_m).cast<double>();
      moments += apart * apart.transpose();
    }
    const Eigen::Vector3f normal = thinnest_direction(moments).cast<float>();
    return normal.dot(middle_m) > 0 ? Eigen::Vector3f(-normal) : normal;
  }
};

/// Where the block's ray meets the plane through its neighbours.
std::optional<SurfacePoint> surface_at(const SensorView& view, const DepthInstant& instant, int x,
                                       int y, const MovingSurfaceOptions& options) {
  const Neighbours around(view, instant, x, y, options.same_surface_m);
  if (around.count < options.min_neighbours) return std::nullopt;
  const Eigen::Vector3f middle = around.middle();
  const Eigen::Vector3f normal = around.normal(middle);
  if (!(-normal.dot(middle.normalized()) >= options.min_incidence)) return std::nullopt;
  const Eigen::Vector3f seen = block_point(view, instant, x, y);
  const Eigen::Vector3f ray = seen.normalized();
  const float distance_m = middle.dot(normal) / ray.dot(normal);
  if (!(std::abs(distance_m - seen.norm()) <= options.same_surface_m)) return std::nullopt;
  return SurfacePoint{distance_m * ray, normal};
}

}  // namespace

std::vector<MovingSurface> moving_surfaces(const SensorView& view,
                                           const MovingSurfaceOptions& options) {
  std::vector<MovingSurface> surfaces;
  for (const DepthInstant& instant : view.instants) {
    const int width = instant.moving.width(), height = instant.moving.height();
    const SurfacePoint none{Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero()};
    MovingSurface surface{instant.time_s, Image<SurfacePoint>(width, height, none), {}};
    for (int y = 1; y + 1 < height; ++y) {
      for (int x = 1; x + 1 < width; ++x) {
        if (instant.moving.at(x, y) == 0) continue;
        const auto here = surface_at(view, instant, x, y, options);
        if (!here) continue;
        surface.at.at(x, y) = *here;
        surface.blocks.emplace_back(x, y);
      }
    }
    surfaces.push_back(std::move(surface));
  }
  return surfaces;
}

}  // namespace roomcast::alignment
