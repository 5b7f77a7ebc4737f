// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/view/depth_surface.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace roomcast::alignment {
namespace {

Image<float> metres_of(DepthView depth_mm, const DepthSurfaceOptions& options) {
  const float nearest_m = options.nearest_m, farthest_m = options.farthest_m;
  Image<float> z_m(depth_mm.width, depth_mm.height);
  for (int y = 0; y < depth_mm.height; ++y) {
    for (int x = 0; x < depth_mm.width; ++x) {
      const float z = 0.001F * static_cast<float>(depth_mm.at(x, y));
      z_m.at(x, y) = z > nearest_m && z < farthest_m ? z : 0;
    }
  }
  return z_m;
}

/// Bilateral filter (Tomasi & Manduchi 1998) with a range kernel that reaches 0, so that readings
/// across an edge do not contribute.
float smoothed(const DepthSurface& surface, int x, int y) {
  const Image<float>& z_m = surface.z_m;
  const float centre = z_m.at(x, y);
  const float reach = surface.options.smooth_sigmas * surface.options.noise.sigma_m(centre);
  float sum = 0, weight = 0;
  for (int dy = -kSmoothReach; dy <= kSmoothReach; ++dy) {
    for (int dx = -kSmoothReach; dx <= kSmoothReach; ++dx) {
      const float z = z_m.at(x + dx, y + dy);
      const float part = (z - centre) / reach;
      const float w = std::max(0.F, 1 - part * part);
      sum += w * z;
      weight += w;
    }
  }
  return sum / weight;
}

bool is_smooth(const DepthSurface& surface, int x, int y) {
  if (surface.range.complete.at(x, y) == 0) return false;
  const float range = surface.range.farthest_m.at(x, y) - surface.range.nearest_m.at(x, y);
  return range < surface.options.max_range_per_depth * surface.z_m.at(x, y);
}

void place_points(DepthSurface& surface) {
  const auto rays = ray_table(surface.camera);
  for (int y = 0; y < surface.at.height(); ++y) {
    for (int x = 0; x < surface.at.width(); ++x) {
      SurfacePoint& here = surface.at.at(x, y);
      here = {Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero()};
      const Eigen::Vector2f& ray = rays.at(x, y);
      if (!(surface.z_m.at(x, y) > 0) || std::isnan(ray.x())) continue;
      const float z = is_smooth(surface, x, y) ? smoothed(surface, x, y) : surface.z_m.at(x, y);
      here.point_m = z * ray.homogeneous();
    }
  }
}

Eigen::Vector3f normal_at(const DepthSurface& surface, int x, int y) {
  const auto& at = surface.at;
  const int reach = surface.options.normal_reach_px;
  const Eigen::Vector3f across = at.at(x + reach, y).point_m - at.at(x - reach, y).point_m;
  const Eigen::Vector3f down = at.at(x, y + reach).point_m - at.at(x, y - reach).point_m;
  const Eigen::Vector3f normal = down.cross(across).normalized();  // towards the camera
  const Eigen::Vector3f view = at.at(x, y).point_m.normalized();
  return -normal.dot(view) > surface.options.min_incidence ? normal : Eigen::Vector3f::Zero();
}

void place_normals(DepthSurface& surface) {
  for (int y = 0; y < surface.at.height(); ++y) {
    for (int x = 0; x < surface.at.width(); ++x) {
      SurfacePoint& here = surface.at.at(x, y);
      if (here.point_m.z() > 0 && is_smooth(surface, x, y)) here.normal = normal_at(surface, x, y);
    }
  }
}

void take_samples(DepthSurface& surface) {
  const int step = surface.options.sample_step_px;
  for (int y = 0; y < surface.at.height(); y += step) {
    for (int x = 0; x < surface.at.width(); x += step) {
      const SurfacePoint& here = surface.at.at(x, y);
      if (here.normal.squaredNorm() > 0) surface.samples.push_back(here);
    }
  }
}

}  // namespace

DepthSurface depth_surface(DepthView depth_mm, const CameraIntrinsics& camera,
                           const DepthSurfaceOptions& options) {
  DepthSurface surface{camera, Lens(camera), metres_of(depth_mm, options), {}, {}, {}, options};
  surface.range = window_range(surface.z_m, options.normal_reach_px);
  surface.at.resize(depth_mm.width, depth_mm.height);
  place_points(surface);
  place_normals(surface);
  take_samples(surface);
  return surface;
}

}  // namespace roomcast::alignment
