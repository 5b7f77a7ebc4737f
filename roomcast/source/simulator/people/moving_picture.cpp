// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulator/people/moving_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "roomcast/source/simulator/tracing/lighting.h"

namespace roomcast::sim {
namespace {

using Eigen::Vector3f;

constexpr std::array<std::array<int, 2>, 4> kNeighbours = {{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

/// Share of a pixel that is covered, from how many of its neighbours are covered too.
float coverage(const MovingLayer& layer, const Image<float>& plate_z_m, int x, int y) {
  float covered = 0.5F;
  for (const auto& [dx, dy] : kNeighbours) {
    const int nx = std::clamp(x + dx, 0, plate_z_m.width() - 1);
    const int ny = std::clamp(y + dy, 0, plate_z_m.height() - 1);
    if (is_in_front(layer, plate_z_m, nx, ny)) covered += 0.125F;
  }
  return covered;
}

Rgb8 blended(const Rgb8& behind, const Vector3f& srgb, float share) {
  const auto channel = [share](std::uint8_t under, float over) {
    const auto base = static_cast<float>(under);
    return static_cast<std::uint8_t>(base + share * (over - base) + 0.5F);
  };
  return {channel(behind.r, srgb.x()), channel(behind.g, srgb.y()), channel(behind.b, srgb.z())};
}

Rgb8 dimmed(const Rgb8& color, float left) {
  const auto channel = [left](std::uint8_t value) {
    return static_cast<std::uint8_t>(static_cast<float>(value) * left + 0.5F);
  };
  return {channel(color.r), channel(color.g), channel(color.b)};
}

}  // namespace

void put_moving_depth(const MovingLayer& layer, const DepthPlate& plate,
                      ImageView<std::uint16_t> depth_mm) {
  const PixelBox& box = layer.box();
  for (int y = box.top; y < box.bottom; ++y) {
    for (int x = box.left; x < box.right; ++x) {
      if (!is_in_front(layer, plate.z_m, x, y)) continue;
      depth_mm.at(x, y) = static_cast<std::uint16_t>(1000.0F * layer.z_m().at(x, y) + 0.5F);
    }
  }
}

void MovingColors::light(const MovingThings& things, const Room& room) {
  room_ = &room;
  ++instant_;
  light_.resize(things.mesh().positions.size());
  lit_when_.resize(light_.size(), 0);
  shade_.work_out(things.shade_balls(), room);
}

const Vector3f& MovingColors::light_at(const MovingThings& things, std::uint32_t vertex) {
  if (lit_when_[vertex] == instant_) return light_[vertex];
  lit_when_[vertex] = instant_;
  const LitPoint at{things.mesh().positions[vertex], things.mesh().normals[vertex]};
  const float open = things.openness()[vertex];
  Vector3f light = ambient_light(*room_, at, open);
  constexpr float kGlare = 1.1F;  // heads come near to lamps
  for (const Light& lamp : room_->lights)
    light += (0.3F + 0.7F * open) * light_from(lamp, at).cwiseMin(kGlare);
  return light_[vertex] = light;
}

void MovingColors::put_shade(const Room& room, const PlacedCamera& camera, const ColorPlate& plate,
                             ImageView<Rgb8> color) const {
  constexpr float kFloor_m = 0.03F;  // rugs too
  const Eigen::AlignedBox2f& area = shade_.area_m();
  if (area.isEmpty() || room.people.empty()) return;
  const PixelBox box =
      camera.pixels_of_box(Eigen::Affine3f::Identity(), {area.min().x(), 0, area.min().y()},
                           {area.max().x(), kFloor_m, area.max().y()});
  for (int y = box.top; y < box.bottom; ++y) {
    for (int x = box.left; x < box.right; ++x) {
      const Vector3f point = camera.point(x, y, plate.z_m.at(x, y));
      if (point.y() > kFloor_m || !area.contains(Eigen::Vector2f(point.x(), point.z()))) continue;
      const float left = shade_.light_left(point.x(), point.z());
      // The plate is in display values, which are about the square root of light.
      if (left < 0.995F) color.at(x, y) = dimmed(color.at(x, y), std::sqrt(left));
    }
  }
}

void MovingColors::put(const MovingThings& things, const MovingLayer& layer,
                       const ColorPlate& plate, const SurfaceTexels& texels,
                       ImageView<Rgb8> color) {
  const TriangleMesh& mesh = things.mesh();
  const PixelBox& box = layer.box();
  for (int y = box.top; y < box.bottom; ++y) {
    for (int x = box.left; x < box.right; ++x) {
      if (!is_in_front(layer, plate.z_m, x, y)) continue;
      const std::uint32_t triangle = layer.triangle().at(x, y);
      const auto& corner = mesh.triangles[triangle];
      const Eigen::Vector2f share = layer.corner_shares().at(x, y);
      const float first = 1.0F - share.x() - share.y();
      const Eigen::Vector2f uv = first * mesh.uv_m[corner[0]] + share.x() * mesh.uv_m[corner[1]] +
                                 share.y() * mesh.uv_m[corner[2]];
      const Vector3f light = first * light_at(things, corner[0]) +
                             share.x() * light_at(things, corner[1]) +
                             share.y() * light_at(things, corner[2]);
      const Vector3f albedo = texels.at(mesh.surface[triangle], uv);
      const Vector3f srgb = srgb_from_linear(albedo.cwiseProduct(light));
      Rgb8& pixel = color.at(x, y);
      pixel = blended(pixel, srgb, coverage(layer, plate.z_m, x, y));
    }
  }
}

}  // namespace roomcast::sim
