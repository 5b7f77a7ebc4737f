// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/tracing/placed_camera.h"

#include <algorithm>

namespace roomcast::simulator {

using Eigen::Vector2d;
using Eigen::Vector3f;

PlacedCamera::PlacedCamera(const CameraIntrinsics& intrinsics,
                           const RigidTransform& world_from_camera)
    : intrinsics_(intrinsics),
      world_from_camera_(world_from_camera),
      camera_from_world_(world_from_camera.inverse()),
      eye_m_(world_from_camera.translation_m.cast<float>()),
      axes_(world_from_camera.rotation.cast<float>()),
      pixel_angle_(static_cast<float>(1.0 / intrinsics.fx)),
      ray_x_(intrinsics.width, intrinsics.height),
      ray_y_(intrinsics.width, intrinsics.height) {
  const Image<Eigen::Vector2f> rays = ray_table(intrinsics);
  for (std::size_t i = 0; i < rays.view().pixel_count(); ++i) {
    const Eigen::Vector2f& ray = rays.data()[i];
    ray_x_.data()[i] = ray.x();
    ray_y_.data()[i] = ray.y();
    if (ray.allFinite()) ray_bounds_.extend(ray);
  }
}

std::optional<Eigen::Vector2f> PlacedCamera::pixel_of(const Vector3f& in_camera_m) const {
  const auto pixel = project(intrinsics_, in_camera_m.cast<double>());
  if (!pixel) return std::nullopt;
  return Eigen::Vector2f(pixel->cast<float>());
}

PixelBox PlacedCamera::pixels_of_box(const Eigen::Affine3f& world_from_local, const Vector3f& low,
                                     const Vector3f& high) const {
  constexpr double kNearest_m = 0.1;
  constexpr double kBulge = 3.0;  // pixels: the lens bends straight edges slightly
  Vector2d least(width(), height());
  Vector2d most(-1, -1);
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3f local((corner & 1) != 0 ? high.x() : low.x(),
                         (corner & 2) != 0 ? high.y() : low.y(),
                         (corner & 4) != 0 ? high.z() : low.z());
    const Eigen::Vector3d seen = camera_from_world_ * (world_from_local * local).cast<double>();
    if (seen.z() < kNearest_m) return {0, 0, width(), height()};
    const auto pixel = project(intrinsics_, seen);
    if (!pixel) return {0, 0, width(), height()};
    least = least.cwiseMin(*pixel);
    most = most.cwiseMax(*pixel);
  }
  const auto inside = [](double value, int limit) {
    return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(limit)));
  };
  return {inside(least.x() - kBulge, width()), inside(least.y() - kBulge, height()),
          inside(most.x() + kBulge + 1.0, width()), inside(most.y() + kBulge + 1.0, height())};
}

}  // namespace roomcast::simulator
