// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/view/lift.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

namespace roomcast::alignment {
namespace {

/// A pixel's ray in the depth camera's frame; `direction` has z = 1 along the colour camera's axis.
struct Ray {
  Eigen::Vector3f origin_m, direction;

  [[nodiscard]] Eigen::Vector3f at(float z_m) const { return origin_m + z_m * direction; }
};

Ray ray_of(const ColorPicture& picture, const Eigen::Vector2f& pixel) {
  const Eigen::Matrix3f depth_from_color = picture.color_from_depth_rotation.transpose();
  const Pinhole& camera = picture.camera;
  return {-(depth_from_color * picture.color_from_depth_m),
          depth_from_color * Eigen::Vector3f((pixel.x() - camera.cx) / camera.fx,
                                             (pixel.y() - camera.cy) / camera.fy, 1)};
}

bool is_edge(float step_m, float z_m, const LiftOptions& options) {
  return step_m > options.edge_step_m + options.edge_step_per_depth * z_m;
}

/// Median depth of the 3x3 pixels around `pixel`; nothing at the border, without readings or at an
/// edge.
std::optional<float> about(const Image<float>& z_m, const Eigen::Vector2f& pixel,
                           const LiftOptions& options) {
  const int u = static_cast<int>(std::lround(pixel.x())),
            v = static_cast<int>(std::lround(pixel.y()));
  if (u < 1 || v < 1 || u >= z_m.width() - 1 || v >= z_m.height() - 1) return std::nullopt;
  std::array<float, 9> around{};
  std::size_t count = 0;
  for (int y = v - 1; y <= v + 1; ++y) {
    for (int x = u - 1; x <= u + 1; ++x) {
      if (z_m.at(x, y) > 0) around[count++] = z_m.at(x, y);
    }
  }
  if (count == 0) return std::nullopt;
  std::sort(around.begin(), around.begin() + static_cast<std::ptrdiff_t>(count));
  const float z = around[count / 2];
  if (is_edge(around[count - 1] - around[0], z, options)) return std::nullopt;
  return z;
}

/// Tangent plane from the four nearest readings, for places where wider windows contain an edge or
/// a gap.
std::optional<SurfacePoint> tangent_of_neighbours(const DepthSurface& surface, int u, int v,
                                                  const LiftOptions& options) {
  if (u < 1 || v < 1 || u >= surface.at.width() - 1 || v >= surface.at.height() - 1)
    return std::nullopt;
  const Eigen::Vector3f here = surface.at.at(u, v).point_m;
  const Eigen::Vector3f left = surface.at.at(u - 1, v).point_m,
                        right = surface.at.at(u + 1, v).point_m;
  const Eigen::Vector3f above = surface.at.at(u, v - 1).point_m,
                        below = surface.at.at(u, v + 1).point_m;
  for (const Eigen::Vector3f& beside : {left, right, above, below}) {
    if (!(beside.z() > 0) || is_edge(std::abs(beside.z() - here.z()), here.z(), options))
      return std::nullopt;
  }
  return SurfacePoint{here, (below - above).cross(right - left).normalized()};
}

/// The surface in the depth pixel onto which `point_m` projects.
std::optional<SurfacePoint> tangent_at(const DepthSurface& surface, const Eigen::Vector3f& point_m,
                                       const LiftOptions& options) {
  Eigen::Vector2f pixel;
  if (!surface.lens.project(point_m, pixel)) return std::nullopt;
  const int u = static_cast<int>(std::lround(pixel.x())),
            v = static_cast<int>(std::lround(pixel.y()));
  if (u < 0 || v < 0 || u >= surface.at.width() || v >= surface.at.height()) return std::nullopt;
  const SurfacePoint& seen = surface.at.at(u, v);
  if (seen.normal.squaredNorm() > 0) return seen;
  return tangent_of_neighbours(surface, u, v, options);
}

}  // namespace

std::optional<Eigen::Vector3f> lift(const ColorPicture& picture, const DepthSurface& surface,
                                    const Eigen::Vector2f& pixel, const LiftOptions& options) {
  const auto coarse_m = about(picture.z_m, pixel, options);
  if (!coarse_m) return std::nullopt;
  const Ray ray = ray_of(picture, pixel);
  float z_m = *coarse_m;
  for (int i = 0; i < options.steps; ++i) {
    const auto seen = tangent_at(surface, ray.at(z_m), options);
    if (!seen) break;
    z_m = seen->normal.dot(seen->point_m - ray.origin_m) / seen->normal.dot(ray.direction);
    if (!(std::abs(z_m - *coarse_m) <
          options.edge_step_m + options.edge_step_per_depth * *coarse_m))
      return std::nullopt;
  }
  return ray.at(z_m);
}

}  // namespace roomcast::alignment
