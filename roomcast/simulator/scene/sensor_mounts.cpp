// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/scene/sensor_mounts.h"

#include <algorithm>

namespace roomcast::simulator {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

/// At a share of the room's half size from its centre, as near to the wall as a bracket allows.
SensorMount stand_at(const Vector3f& room_size_m, const Vector2f& share, float height_m,
                     const Vector2f& looks_past_middle_m, Random& random) {
  const float bracket_m = random.between(0.30F, 0.38F);
  const Vector2f half =
      0.5F * Vector2f(room_size_m.x(), room_size_m.z()) - Vector2f::Constant(bracket_m);
  SensorMount mount;
  mount.eye_m = {share.x() * half.x(), std::min(height_m, room_size_m.y() - 0.3F),
                 share.y() * half.y()};
  mount.target_m = {looks_past_middle_m.x() + random.between(-0.2F, 0.2F),
                    random.between(0.7F, 0.9F),
                    looks_past_middle_m.y() + random.between(-0.2F, 0.2F)};
  return mount;
}

}  // namespace

Stands draw_sensor_mounts_around(const Vector3f& size, Random& random) {
  const auto mid = [&] { return random.between(-0.15F, 0.15F); };
  return {stand_at(size, {-0.96F, -0.94F}, random.between(1.8F, 2.0F), {0.45F, 0.30F}, random),
          stand_at(size, {0.96F, -0.92F}, random.between(1.7F, 1.9F), {-0.50F, 0.20F}, random),
          stand_at(size, {mid(), 1.0F}, random.between(2.0F, 2.15F), {0.1F, -0.55F}, random),
          stand_at(size, {-0.94F, 0.96F}, random.between(1.7F, 1.9F), {0.55F, -0.35F}, random),
          stand_at(size, {0.95F, 0.95F}, random.between(1.9F, 2.1F), {-0.35F, -0.20F}, random),
          stand_at(size, {mid(), -1.0F}, random.between(1.9F, 2.1F), {0.1F, 0.45F}, random),
          stand_at(size, {-1.0F, mid()}, random.between(2.0F, 2.15F), {0.4F, 0.0F}, random),
          stand_at(size, {1.0F, mid()}, random.between(1.9F, 2.1F), {-0.4F, 0.0F}, random)};
}

Stands draw_sensor_mounts_in_corners(const Vector3f& size, Random& random) {
  const auto high = [&] { return random.between(1.9F, 2.1F); };
  const auto mid = [&] { return random.between(-0.2F, 0.2F); };
  return {stand_at(size, {-1.0F, -1.0F}, high(), {0.35F, 0.30F}, random),
          stand_at(size, {1.0F, -1.0F}, high(), {-0.35F, 0.30F}, random),
          stand_at(size, {1.0F, 1.0F}, high(), {-0.35F, -0.30F}, random),
          stand_at(size, {-1.0F, 1.0F}, high(), {0.35F, -0.30F}, random),
          stand_at(size, {mid(), 1.0F}, high(), {0.0F, -0.5F}, random),
          stand_at(size, {mid(), -1.0F}, high(), {0.0F, 0.5F}, random),
          stand_at(size, {-1.0F, mid()}, high(), {0.5F, 0.0F}, random),
          stand_at(size, {1.0F, mid()}, high(), {-0.5F, 0.0F}, random)};
}

Stands draw_sensor_mounts_on_tripods(const Vector3f& size, Random& random) {
  Stands sensor_mounts = draw_sensor_mounts_around(size, random);
  const std::array<Vector2f, kTripods> places_m = {Vector2f(0, 2.25F), Vector2f(2.3F, 0.2F),
                                                   Vector2f(-2.3F, 0.2F), Vector2f(0, -2.2F)};
  for (std::size_t i = 0; i < places_m.size(); ++i) {
    const Vector2f at =
        places_m[i] + Vector2f(random.between(-0.1F, 0.1F), random.between(-0.1F, 0.1F));
    sensor_mounts[i].eye_m = {at.x(), random.between(1.35F, 1.65F), at.y()};
    sensor_mounts[i].target_m = {random.between(-0.1F, 0.1F), random.between(0.85F, 0.95F),
                                 random.between(-0.1F, 0.1F)};
  }
  return sensor_mounts;
}

}  // namespace roomcast::simulator
