// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/tracing/light_map.h"

#include <algorithm>
#include <cmath>

#include "roomcast/core/assert.h"
#include "roomcast/simulator/random/value_noise.h"

namespace roomcast::simulator {
namespace {

using Eigen::Vector3f;

constexpr int kSpacing = 4;  // pixels
constexpr int kNodeRays = 16, kPixelRays = 4;
constexpr float kDisagreement = 0.3F;

/// Weight of a map node for a point: high if it is near, similarly oriented and on the same plane.
float likeness(const LitPoint& node, const LitPoint& point) {
  const float same_way = std::max(0.0F, node.normal.dot(point.normal));
  const Vector3f way = node.position_m - point.position_m;
  const float off_plane = point.normal.dot(way) / 0.02F;
  const float squared = same_way * same_way;
  return squared * squared * squared / (1.0F + off_plane * off_plane + 10.0F * way.norm());
}

}  // namespace

LightMap::LightMap(const Room& room, const RayScene& scene, const PlacedCamera& camera,
                   const Workers& workers)
    : room_(room),
      scene_(scene),
      nodes_((camera.width() + kSpacing - 1) / kSpacing,
             (camera.height() + kSpacing - 1) / kSpacing) {
  ROOMCAST_ASSERT(room.lights.size() <= kMaxLights);
  for_each_row(nodes_.height(), workers, [&](int j) {
    for (int i = 0; i < nodes_.width(); ++i)
      nodes_.at(i, j) = node_at(i * kSpacing, j * kSpacing, camera);
  });
}

LightMap::Node LightMap::node_at(int x, int y, const PlacedCamera& camera) const {
  Node node;
  const Vector3f direction = camera.direction(x, y);
  const auto hit = scene_.first_hit(camera.eye_m(), direction);
  if (!hit) return node;
  node.is_surface = true;
  node.point = {camera.eye_m() + hit->t * direction, hit->normal};
  node.openness = openness_at(scene_, node.point);
  const auto dither = hash_of(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
  for (std::size_t i = 0; i < room_.lights.size(); ++i) {
    node.lamp_seen[i] = share_of_lamp_seen(scene_, room_.lights[i], node.point, kNodeRays, dither);
  }
  return node;
}

LightMap::Blend LightMap::blend_around(int x, int y, const LitPoint& point) const {
  Blend blend;
  blend.least_seen.fill(1.0F);
  for (int corner = 0; corner < 4; ++corner) {
    const int i = std::min(x / kSpacing + (corner & 1), nodes_.width() - 1);
    const int j = std::min(y / kSpacing + (corner >> 1), nodes_.height() - 1);
    const Node& node = nodes_.at(i, j);
    if (!node.is_surface) continue;
    const float across = 1.0F - std::abs(static_cast<float>(x - i * kSpacing)) / kSpacing;
    const float down = 1.0F - std::abs(static_cast<float>(y - j * kSpacing)) / kSpacing;
    const float alike = likeness(node.point, point);
    const float weight = (std::max(0.0F, across * down) + 0.01F) * alike;
    blend.weight += weight;
    blend.openness += weight * node.openness;
    for (std::size_t lamp = 0; lamp < room_.lights.size(); ++lamp) {
      blend.lamp_seen[lamp] += weight * node.lamp_seen[lamp];
      if (alike < 0.1F) continue;
      blend.least_seen[lamp] = std::min(blend.least_seen[lamp], node.lamp_seen[lamp]);
      blend.most_seen[lamp] = std::max(blend.most_seen[lamp], node.lamp_seen[lamp]);
    }
  }
  return blend;
}

Vector3f LightMap::arriving(int x, int y, const LitPoint& point, std::uint32_t dither) const {
  constexpr float kEnough = 0.02F;
  const Blend blend = blend_around(x, y, point);
  const bool known = blend.weight > kEnough;
  const float openness = known ? blend.openness / blend.weight : openness_at(scene_, point);
  Vector3f sum = ambient_light(room_, point, openness);
  for (std::size_t i = 0; i < room_.lights.size(); ++i) {
    const Light& lamp = room_.lights[i];
    const Vector3f light = light_from(lamp, point);
    if (light.maxCoeff() < 0.004F) continue;
    const bool agreed = known && blend.most_seen[i] - blend.least_seen[i] < kDisagreement;
    sum += light * (agreed ? blend.lamp_seen[i] / blend.weight
                           : share_of_lamp_seen(scene_, lamp, point, kPixelRays, dither));
  }
  return sum;
}

}  // namespace roomcast::simulator
