// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/export/depth_points.h"

#include <cmath>

#include <Eigen/Geometry>

#include "roomcast/core/assert.h"

namespace roomcast::recording {

DepthPoints::DepthPoints(const CameraIntrinsics& camera)
    : camera_(camera),
      rays_(ray_table(camera)),
      points_m_(camera.width, camera.height, Eigen::Vector3f::Zero()),
      normals_(camera.width, camera.height, Eigen::Vector3f::Zero()) {}

void DepthPoints::set(DepthView depth_mm) {
  ROOMCAST_ASSERT(depth_mm.width == camera_.width && depth_mm.height == camera_.height);
  unproject(depth_mm);
  normals_.resize(camera_.width, camera_.height, Eigen::Vector3f::Zero());
  for (int y = 1; y + 1 < camera_.height; ++y) {
    for (int x = 1; x + 1 < camera_.width; ++x) find_normal(x, y);
  }
}

void DepthPoints::unproject(DepthView depth_mm) {
  for (int y = 0; y < camera_.height; ++y) {
    for (int x = 0; x < camera_.width; ++x) {
      const Eigen::Vector2f ray = rays_.at(x, y);
      const bool has_ray = std::isfinite(ray.x()) && std::isfinite(ray.y());
      const float z = has_ray ? 0.001F * static_cast<float>(depth_mm.at(x, y)) : 0.0F;
      points_m_.at(x, y) = has_ray ? Eigen::Vector3f(ray.x() * z, ray.y() * z, z)
                                   : Eigen::Vector3f(Eigen::Vector3f::Zero());
    }
  }
}

void DepthPoints::find_normal(int x, int y) {
  const Eigen::Vector3f& here = points_m_.at(x, y);
  if (here.z() <= 0) return;
  const float limit = largest_step_m(here.z());
  const auto is_near = [&](const Eigen::Vector3f& p) {
    return p.z() > 0 && std::abs(p.z() - here.z()) < limit;
  };
  const Eigen::Vector3f& left = points_m_.at(x - 1, y);
  const Eigen::Vector3f& right = points_m_.at(x + 1, y);
  const Eigen::Vector3f& above = points_m_.at(x, y - 1);
  const Eigen::Vector3f& below = points_m_.at(x, y + 1);
  if (!is_near(left) || !is_near(right) || !is_near(above) || !is_near(below)) return;
  Eigen::Vector3f normal = (below - above).cross(right - left);
  const float length = normal.norm();
  if (length <= 0) return;
  normal /= length;
  normals_.at(x, y) = normal.dot(here) > 0 ? Eigen::Vector3f(-normal) : normal;
}

}  // namespace roomcast::recording
