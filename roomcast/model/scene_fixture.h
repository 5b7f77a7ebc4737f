// SPDX-License-Identifier: Apache-2.0
// For tests: sensors that look without error, or with noise of a given size, at a scene of which
// every distance is known: a floor, a wall, a ball and a box.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include "roomcast/model/still_view.h"
#include "roomcast/model/view_surface.h"

namespace roomcast::model {

/// Signed distance to the surfaces of a scene, positive where nothing is.
using SceneDistance = std::function<double(const Eigen::Vector3d&)>;

inline double floor_and_wall(const Eigen::Vector3d& at) {
  return std::min(at.y(), at.z() + 2);
}
inline double ball(const Eigen::Vector3d& at, const Eigen::Vector3d& center, double radius) {
  return (at - center).norm() - radius;
}
inline double box(const Eigen::Vector3d& at, const Eigen::Vector3d& center,
                  const Eigen::Vector3d& half) {
  const Eigen::Vector3d out = (at - center).cwiseAbs() - half;
  return out.cwiseMax(0).norm() + std::min(out.maxCoeff(), 0.0);
}

inline const Eigen::Vector3d kBall_m(-0.5, 0.6, -0.8), kBox_m(0.6, 0.25, -1.0);
inline const Eigen::Vector3d kBoxHalf_m(0.3, 0.25, 0.2);
inline constexpr double kBallRadius_m = 0.3;

inline double known_scene(const Eigen::Vector3d& at) {
  return std::min(
      {floor_and_wall(at), ball(at, kBall_m, kBallRadius_m), box(at, kBox_m, kBoxHalf_m)});
}

inline CameraIntrinsics fixture_camera() {
  return {.width = 256,
          .height = 212,
          .fx = 183,
          .fy = 183,
          .cx = 127.5,
          .cy = 105.5,
          .k1 = 0.05,
          .k2 = -0.08};
}

/// Depth by sphere tracing; 0 beyond 8 m.
inline DepthImage look(const CameraIntrinsics& camera, const RigidTransform& pose,
                       const SceneDistance& scene, double noise_mm = 0, unsigned seed = 1) {
  const auto rays = ray_table(camera);
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, std::max(noise_mm, 1e-9));
  DepthImage depth_mm(camera.width, camera.height);
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const Eigen::Vector3d ray = rays.at(x, y).cast<double>().homogeneous().normalized();
      double way_m = 0.1, step_m = 1;
      while (step_m > 1e-5 && way_m < 8)
        way_m += step_m = scene(pose * Eigen::Vector3d(way_m * ray));
      if (way_m >= 8) continue;
      const double z_mm = 1000 * way_m * ray.z() + (noise_mm > 0 ? noise(random) : 0);
      depth_mm.at(x, y) = static_cast<std::uint16_t>(std::lround(z_mm));
    }
  }
  return depth_mm;
}

inline std::vector<RigidTransform> fixture_poses() {
  return {world_from_optical_looking_at({-1.2, 1.6, 1.2}, {0, 0.4, -1}),
          world_from_optical_looking_at({1.4, 1.8, 0.9}, {0, 0.4, -1}),
          world_from_optical_looking_at({0, 1.2, 1.5}, {0, 0.5, -1})};
}

/// Views of the scene from all fixture_poses(), of `frames` frames each.
inline std::vector<ViewSurface> look_from_all(const SceneDistance& scene,
                                              const ModelOptions& options = {}, int frames = 1,
                                              double noise_mm = 0) {
  std::vector<ViewSurface> views;
  unsigned seed = 1;
  for (const RigidTransform& pose : fixture_poses()) {
    StillView view = *StillView::create(fixture_camera(), pose, options);
    const ColorImage color(256, 212, Rgb8{200, 100, 50});
    for (int i = 0; i < frames; ++i)
      view.add(look(fixture_camera(), pose, scene, noise_mm, seed++), color, {});
    views.emplace_back(view, options);
  }
  return views;
}

}  // namespace roomcast::model
