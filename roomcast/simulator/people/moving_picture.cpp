// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/people/moving_picture.h"

#include <algorithm>
#include <cmath>

#include "roomcast/simulator/tracing/lighting.h"

namespace roomcast::simulator {
namespace {

using Eigen::Array4f;
using Eigen::Vector2f;
using Eigen::Vector3f;

/// The values that determine a pixel's colour: linear over its triangle.
struct OverTriangle {
  std::uint32_t number = MovingLayer::kNoTriangle;
  SurfaceIndex surface = 0;
  Array4f light = Array4f::Zero(), light_to_second = light, light_to_third = light;
  Vector2f uv = Vector2f::Zero(), uv_to_second = uv, uv_to_third = uv;
};

Rgb8 blended(const Rgb8& behind, const Array4f& srgb, float share) {
  const auto channel = [share](std::uint8_t under, float over) {
    const auto base = static_cast<float>(under);
    return static_cast<std::uint8_t>(base + share * (over - base) + 0.5F);
  };
  return {channel(behind.r, srgb[0]), channel(behind.g, srgb[1]), channel(behind.b, srgb[2])};
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

const Array4f& MovingColors::light_at(const MovingThings& things, std::uint32_t vertex) {
  if (lit_when_[vertex] == instant_) return light_[vertex];
  lit_when_[vertex] = instant_;
  const LitPoint at{things.mesh().positions[vertex], things.mesh().normals[vertex]};
  const float open = things.openness()[vertex];
  Vector3f light = ambient_light(*room_, at, open);
  constexpr float kGlare = 1.1F;  // limit per lamp: heads come close to lamps
  for (const Light& lamp : room_->lights)
    light += (0.3F + 0.7F * open) * light_from(lamp, at).cwiseMin(kGlare);
  return light_[vertex] = {light.x(), light.y(), light.z(), 0.0F};
}

void MovingColors::put_shade(const Room& room, const PlacedCamera& camera, const ColorPlate& plate,
                             ImageView<Rgb8> color) const {
  constexpr float kFloor_m = 0.03F;  // maximum height of floor surfaces, including rugs
  const Eigen::AlignedBox2f& area = shade_.area_m();
  if (area.isEmpty() || room.people.empty()) return;
  const PixelBox box =
      camera.pixels_of_box(Eigen::Affine3f::Identity(), {area.min().x(), 0, area.min().y()},
                           {area.max().x(), kFloor_m, area.max().y()});
  for (int y = box.top; y < box.bottom; ++y) {
    for (int x = box.left; x < box.right; ++x) {
      const Vector3f point = camera.point(x, y, plate.z_m.at(x, y));
      if (point.y() > kFloor_m || !area.contains(Eigen::Vector2f(point.x(), point.z()))) continue;
      color.at(x, y) = dimmed(color.at(x, y), shade_.display_left(point.x(), point.z()));
    }
  }
}

void MovingColors::find_front(const MovingLayer& layer, const Image<float>& plate_z_m) {
  const PixelBox& box = layer.box();
  const int width = box.right - box.left;
  front_.resize(width + 2, box.bottom - box.top + 2);
  for (int y = box.top; y < box.bottom; ++y) {
    std::uint8_t* front = front_.view().row(y - box.top + 1) + 1;
    for (int x = box.left; x < box.right; ++x)
      front[x - box.left] = is_in_front(layer, plate_z_m, x, y) ? 1 : 0;
    // Treats the surface as continuing beyond the picture's edge.
    if (box.left == 0) front[-1] = front[0];
    if (box.right == plate_z_m.width()) front[width] = front[width - 1];
  }
  const auto copy_row = [&](int from, int to) {
    std::copy_n(front_.view().row(from), front_.width(), front_.view().row(to));
  };
  if (box.top == 0) copy_row(1, 0);
  if (box.bottom == plate_z_m.height()) copy_row(front_.height() - 2, front_.height() - 1);
}

void MovingColors::put(const MovingThings& things, const MovingLayer& layer,
                       const ColorPlate& plate, const SurfaceTexels& texels,
                       ImageView<Rgb8> color) {
  const TriangleMesh& mesh = things.mesh();
  const PixelBox& box = layer.box();
  if (box.empty()) return;
  find_front(layer, plate.z_m);
  OverTriangle over;
  const auto move_to_triangle = [&](std::uint32_t number) {
    const auto& corner = mesh.triangles[number];
    over.number = number;
    over.surface = mesh.surface[number];
    over.light = light_at(things, corner[0]);
    over.light_to_second = light_at(things, corner[1]) - over.light;
    over.light_to_third = light_at(things, corner[2]) - over.light;
    over.uv = mesh.uv_m[corner[0]];
    over.uv_to_second = mesh.uv_m[corner[1]] - over.uv;
    over.uv_to_third = mesh.uv_m[corner[2]] - over.uv;
  };
  for (int y = box.top; y < box.bottom; ++y) {
    const std::ptrdiff_t stride = front_.width();
    const std::uint8_t* front = front_.view().row(y - box.top + 1) + 1 - box.left;
    for (int x = box.left; x < box.right; ++x) {
      if (front[x] == 0) continue;
      const std::uint32_t number = layer.triangle().at(x, y);
      if (number != over.number) move_to_triangle(number);
      const Vector2f share = layer.corner_shares().at(x, y);
      const Vector2f uv = over.uv + share.x() * over.uv_to_second + share.y() * over.uv_to_third;
      const Array4f light =
          over.light + share.x() * over.light_to_second + share.y() * over.light_to_third;
      const Array4f srgb = srgb_from_linear(Array4f(texels.at(over.surface, uv) * light));
      // Coverage of the pixel, estimated from the number of covered neighbours.
      const int covered = front[x - 1] + front[x + 1] + front[x - stride] + front[x + stride];
      Rgb8& pixel = color.at(x, y);
      pixel = blended(pixel, srgb, 0.5F + 0.125F * static_cast<float>(covered));
    }
  }
}

}  // namespace roomcast::simulator
