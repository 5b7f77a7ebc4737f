// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/tracing/multipath.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "roomcast/simulator/tracing/lighting.h"

namespace roomcast::simulator {
namespace {

using Eigen::Vector3f;

constexpr int kSpacing = 4;  // pixels
constexpr int kRays = 48;
constexpr float kPhaseTurn = 2.0F * std::numbers::pi_v<float>;
constexpr std::array kHalfWaves_m = {1.875F, 1.25F};  // of light modulated at 80 and 120 MHz

struct Node {
  float z_m = 0;  // 0: no surface
  Vector3f normal = Vector3f::Zero();
  float detour_m = 0;  // along the ray
};

/// The camera lights only what is inside its picture.
bool in_picture(const PlacedCamera& camera, const Vector3f& point_m) {
  const auto pixel = camera.pixel_of(camera.axes().transpose() * (point_m - camera.eye_m()));
  return pixel && pixel->x() > -0.5F && pixel->y() > -0.5F &&
         pixel->x() < static_cast<float>(camera.width()) - 0.5F &&
         pixel->y() < static_cast<float>(camera.height()) - 0.5F;
}

/// The camera's light on a surface, up to a constant factor; 0 in shadow or outside the picture.
float lit_by_camera(const RayScene& scene, const PlacedCamera& camera, const LitPoint& at) {
  const Vector3f way = camera.eye_m() - at.position_m;
  const float distance = way.norm();
  const float cosine = at.normal.dot(way) / distance;
  if (cosine <= 0.0F || !in_picture(camera, at.position_m)) return 0.0F;
  if (scene.blocked(at.position_m + 0.003F * at.normal, camera.eye_m())) return 0.0F;
  return cosine / (distance * distance);
}

/// Excess distance of P along the ray: from the phase of all light that returns from it.
float detour_at(const Room& room, const RayScene& scene, const PlacedCamera& camera,
                const LitPoint& at) {
  const float direct_way = (at.position_m - camera.eye_m()).norm();
  const float cosine = at.normal.dot(camera.eye_m() - at.position_m) / direct_way;
  std::array<std::complex<float>, kHalfWaves_m.size()> light;
  light.fill(std::max(cosine, 0.05F) / (direct_way * direct_way));
  for (int i = 0; i < kRays; ++i) {
    const Vector3f direction = cosine_direction(at.normal, i, kRays);
    const auto hit = scene.first_hit(at.position_m + 0.004F * at.normal, direction);
    if (!hit) continue;
    const LitPoint bounce{at.position_m + hit->t * direction, hit->normal};
    const float infrared = room.surfaces[room.mesh.surface[hit->triangle]].infrared;
    const float share = infrared * lit_by_camera(scene, camera, bounce) / kRays;
    const float way = hit->t + (bounce.position_m - camera.eye_m()).norm();
    for (std::size_t f = 0; f < light.size(); ++f)
      light[f] += std::polar(share, kPhaseTurn * 0.5F * (way - direct_way) / kHalfWaves_m[f]);
  }
  float sum_m = 0.0F;
  for (std::size_t f = 0; f < light.size(); ++f)
    sum_m += std::arg(light[f]) / kPhaseTurn * kHalfWaves_m[f];
  return std::max(0.0F, sum_m / static_cast<float>(light.size()));
}

Node node_at(const Room& room, const RayScene& scene, const PlacedCamera& camera, int x, int y) {
  const Vector3f direction = camera.direction(x, y);
  const auto hit = scene.first_hit(camera.eye_m(), direction);
  if (!hit) return {};
  const LitPoint at{camera.eye_m() + hit->t * direction, hit->normal};
  return {hit->t, hit->normal, detour_at(room, scene, camera, at)};
}

/// Detour along the axis at a pixel, from the surrounding nodes of similar depth.
float blended(const Image<Node>& nodes, int x, int y, float z_m, float ray_length) {
  float sum = 0.0F, weights = 1e-6F;
  for (int corner = 0; corner < 4; ++corner) {
    const int i = std::min(x / kSpacing + (corner & 1), nodes.width() - 1);
    const int j = std::min(y / kSpacing + (corner >> 1), nodes.height() - 1);
    const Node& node = nodes.at(i, j);
    if (node.z_m <= 0.0F) continue;
    const float across = 1.0F - std::abs(static_cast<float>(x - i * kSpacing)) / kSpacing;
    const float down = 1.0F - std::abs(static_cast<float>(y - j * kSpacing)) / kSpacing;
    const float step = (node.z_m - z_m) / (0.03F + 0.03F * z_m);
    const float weight =
        (std::max(0.0F, across * down) + 0.01F) / (1.0F + step * step * step * step);
    sum += weight * node.detour_m;
    weights += weight;
  }
  return sum / weights / ray_length;
}

}  // namespace

Image<float> trace_detours(const Room& room, const RayScene& scene, const PlacedCamera& camera,
                           ImageView<const float> z_m, const Workers& workers) {
  Image<Node> nodes((camera.width() + kSpacing - 1) / kSpacing,
                    (camera.height() + kSpacing - 1) / kSpacing);
  for_each_row(nodes.height(), workers, [&](int j) {
    for (int i = 0; i < nodes.width(); ++i)
      nodes.at(i, j) = node_at(room, scene, camera, i * kSpacing, j * kSpacing);
  });
  Image<float> detour_m(camera.width(), camera.height());
  for_each_row(camera.height(), workers, [&](int y) {
    for (int x = 0; x < camera.width(); ++x) {
      const float ray_length = camera.direction(x, y).norm();
      if (z_m.at(x, y) > 0.0F) detour_m.at(x, y) = blended(nodes, x, y, z_m.at(x, y), ray_length);
    }
  });
  return detour_m;
}

}  // namespace roomcast::simulator
