// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/tracing/foreign_light.h"

#include <algorithm>
#include <cmath>

namespace roomcast::simulator {
namespace {

using Eigen::Vector3f;

bool lights(const PlacedCamera& projector, const Vector3f& point_m) {
  const Vector3f seen = projector.axes().transpose() * (point_m - projector.eye_m());
  const auto pixel = projector.pixel_of(seen);
  return pixel && pixel->x() >= -0.5F && pixel->y() >= -0.5F &&
         pixel->x() < static_cast<float>(projector.width()) - 0.5F &&
         pixel->y() < static_cast<float>(projector.height()) - 0.5F;
}

/// Of a projector at `eye_m` of strength 1.
float irradiance(const Vector3f& eye_m, const Vector3f& point_m, const Vector3f& normal) {
  const Vector3f towards = eye_m - point_m;
  const float distance_m = std::max(towards.norm(), 0.05F);
  return std::max(0.0F, normal.dot(towards)) / (distance_m * distance_m * distance_m);
}

float foreign_light_at(const RayScene& scene, const PlacedCamera& camera, const PlacedCamera& other,
                       int x, int y) {
  const Vector3f direction = camera.direction(x, y);
  const auto hit = scene.first_hit(camera.eye_m(), direction);
  if (!hit) return 0;
  const Vector3f point_m = camera.eye_m() + hit->t * direction;
  const float foreign = irradiance(other.eye_m(), point_m, hit->normal);
  if (foreign <= 0.0F || !lights(other, point_m) || scene.blocked(point_m, other.eye_m())) return 0;
  const float own = std::max(irradiance(camera.eye_m(), point_m, hit->normal), 1e-6F);
  return std::min(foreign / own, kMaxForeignLight);
}

}  // namespace

Image<float> trace_foreign_light(const RayScene& scene, const PlacedCamera& camera,
                                 const PlacedCamera& other, const Workers& workers) {
  Image<float> light(camera.width(), camera.height());
  for_each_row(camera.height(), workers, [&](int y) {
    for (int x = 0; x < camera.width(); ++x)
      light.at(x, y) = foreign_light_at(scene, camera, other, x, y);
  });
  return light;
}

}  // namespace roomcast::simulator
