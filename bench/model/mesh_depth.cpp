// SPDX-License-Identifier: Apache-2.0
#include "bench/model/mesh_depth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace roomcast::bench {
namespace {

/// A point in the picture: pixels, and 1 / depth, which is linear along a plane; 0 for a point that
/// is not in front of the camera.
struct DrawnPoint {
  float u = 0, v = 0, inverse_m = 0;
};

std::vector<DrawnPoint> drawn_points(const model::RoomMesh& mesh, const CameraIntrinsics& camera,
                                     const RigidTransform& camera_from_world) {
  constexpr double kNear_m = 0.1;
  std::vector<DrawnPoint> points;
  points.reserve(mesh.points_m.size());
  for (const Eigen::Vector3f& point : mesh.points_m) {
    const Eigen::Vector3d at = camera_from_world * point.cast<double>();
    const auto pixel = at.z() > kNear_m ? project(camera, at) : std::nullopt;
    points.push_back(pixel ? DrawnPoint{static_cast<float>(pixel->x()),
                                        static_cast<float>(pixel->y()),
                                        static_cast<float>(1 / at.z())}
                           : DrawnPoint());
  }
  return points;
}

/// Twice the area of a triangle, positive where it is counter-clockwise in a picture whose y points
/// down as seen, which is what faces the camera.
float twice_area(const DrawnPoint& a, const DrawnPoint& b, float u, float v) {
  return (b.v - a.v) * (u - a.u) - (b.u - a.u) * (v - a.v);
}

void draw(const std::array<DrawnPoint, 3>& t, Image<float>& nearest) {
  const float area = twice_area(t[0], t[1], t[2].u, t[2].v);
  if (!(area > 0)) return;
  const auto [left, right] = std::minmax({t[0].u, t[1].u, t[2].u});
  const auto [top, bottom] = std::minmax({t[0].v, t[1].v, t[2].v});
  const int first_x = std::max(0, static_cast<int>(std::ceil(left)));
  const int last_x = std::min(nearest.width() - 1, static_cast<int>(std::floor(right)));
  const int last_y = std::min(nearest.height() - 1, static_cast<int>(std::floor(bottom)));
  for (int y = std::max(0, static_cast<int>(std::ceil(top))); y <= last_y; ++y) {
    for (int x = first_x; x <= last_x; ++x) {
      const auto u = static_cast<float>(x), v = static_cast<float>(y);
      const float a = twice_area(t[1], t[2], u, v) / area, b = twice_area(t[2], t[0], u, v) / area;
      const float c = 1 - a - b;
      constexpr float kOnLine = -1e-4F;  // both triangles at a line draw its pixels
      if (a < kOnLine || b < kOnLine || c < kOnLine) continue;
      float& here = nearest.at(x, y);
      here = std::max(here, a * t[0].inverse_m + b * t[1].inverse_m + c * t[2].inverse_m);
    }
  }
}

}  // namespace

Image<float> mesh_depth_m(const model::RoomMesh& mesh, const CameraIntrinsics& camera,
                          const RigidTransform& world_from_camera) {
  const auto points = drawn_points(mesh, camera, world_from_camera.inverse());
  Image<float> depth_m(camera.width, camera.height);
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::array<DrawnPoint, 3> triangle = {points[a], points[b], points[c]};
    const bool visible =
        std::ranges::all_of(triangle, [](const DrawnPoint& p) { return p.inverse_m > 0; });
    if (visible) draw(triangle, depth_m);
  }
  for (int y = 0; y < camera.height; ++y)
    for (int x = 0; x < camera.width; ++x)
      if (float& z_m = depth_m.at(x, y); z_m > 0) z_m = 1 / z_m;
  return depth_m;
}

}  // namespace roomcast::bench
