// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulator/people/body_layer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace roomcast::sim {
namespace {

using Eigen::Vector3f;

constexpr float kNowhere_m = std::numeric_limits<float>::infinity();

PixelBox joined(const PixelBox& a, const PixelBox& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
          std::max(a.bottom, b.bottom)};
}

PixelBox box_of_part(const BodyPart& part, const PlacedCamera& camera) {
  const float radius = std::max(part.shape.first_radius(), part.shape.second_radius());
  return camera.pixels_of_box(part.world_from_local, {-radius, -part.shape.first_radius(), -radius},
                              {radius, part.shape.length() + part.shape.second_radius(), radius});
}

}  // namespace

BodyLayer::BodyLayer(int width, int height)
    : z_m_(width, height, kNowhere_m), part_(width, height, kNoPart) {}

void BodyLayer::clear() {
  for (int y = box_.top; y < box_.bottom; ++y) {
    std::fill(z_m_.view().row(y) + box_.left, z_m_.view().row(y) + box_.right, kNowhere_m);
    std::fill(part_.view().row(y) + box_.left, part_.view().row(y) + box_.right, kNoPart);
  }
  box_ = {};
}

void BodyLayer::draw(const WalkingBody& body, const PlacedCamera& camera) {
  clear();
  std::uint8_t number = 0;
  for (const BodyPart& part : body.parts()) draw_part(part, number++, camera);
}

void BodyLayer::draw_part(const BodyPart& part, std::uint8_t number, const PlacedCamera& camera) {
  const PixelBox box = box_of_part(part, camera);
  if (box.empty()) return;
  box_ = joined(box_, box);
  // Rays go straight into the part's local frame; t stays what it is: z, because their z is 1.
  const Eigen::Matrix3f local_rays = part.local_from_world.linear() * camera.axes();
  const Vector3f local_eye = part.local_from_world * camera.eye_m();
  for (int y = box.top; y < box.bottom; ++y) {
    const Eigen::Vector2f* rays = camera.ray_row(y);
    float* z_row = z_m_.view().row(y);
    std::uint8_t* part_row = part_.view().row(y);
    for (int x = box.left; x < box.right; ++x) {
      const Vector3f direction =
          local_rays.col(0) * rays[x].x() + local_rays.col(1) * rays[x].y() + local_rays.col(2);
      const auto entry = part.shape.entry(local_eye, direction);
      if (!entry || *entry >= z_row[x]) continue;
      z_row[x] = *entry;
      part_row[x] = number;
    }
  }
}

BodyPoint body_point(const BodyPart& part, const PlacedCamera& camera, int x, int y, float z_m) {
  const Vector3f direction = camera.direction(x, y);
  BodyPoint point;
  point.position_m = camera.eye_m() + z_m * direction;
  const Vector3f local = part.local_from_world * point.position_m;
  point.normal =
      (part.local_from_world.linear().transpose() * part.shape.normal_at(local)).normalized();
  point.cloth_m = cloth_point(part, local);
  point.facing = -point.normal.dot(direction.normalized());
  return point;
}

}  // namespace roomcast::sim
