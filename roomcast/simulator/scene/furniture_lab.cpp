// SPDX-License-Identifier: Apache-2.0
// Furniture of laboratories and meeting rooms: benches with equipment, racks, cable trays, boards.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "roomcast/simulator/random/random.h"
#include "roomcast/simulator/scene/furniture.h"

namespace roomcast::simulator {
namespace {

using Eigen::Affine3f;
using Eigen::AngleAxisf;
using Eigen::Translation3f;
using Eigen::Vector2f;
using Eigen::Vector3f;

void add_knob(Room& room, const Affine3f& front, SurfaceIndex surface, float x, float y) {
  const Affine3f out = front * Translation3f(x, y, 0) * AngleAxisf(1.5708F, Vector3f::UnitX());
  const std::array<Vector2f, 3> knob = {Vector2f(0.013F, 0), {0.011F, 0.014F}, {0, 0.014F}};
  add_turned(room.mesh, surface, out, knob);
}

}  // namespace

void add_instrument(Room& room, const Affine3f& at, const Vector3f& size_m, std::uint32_t seed) {
  constexpr std::array<std::uint32_t, 4> kCases = {0xd8d4c8, 0x5a6268, 0x2f4a5f, 0xb8b2a4};
  Random random(seed);
  const auto body = add_paint(room, random.one_of(kCases), random.seed());
  const auto dark = add_paint(room, 0x232428, random.seed(), 0.2F);
  const float x = 0.5F * size_m.x(), z = 0.5F * size_m.z();
  const float low = 0.012F;
  add_box(room.mesh, body, at, {-x, low, -z}, {x, size_m.y(), z});
  for (const float side : {-0.8F * x, 0.8F * x}) {
    add_box(room.mesh, dark, at, {side - 0.01F, 0, -0.8F * z}, {side + 0.01F, low, 0.8F * z});
  }
  const Affine3f front = at * Translation3f(0, 0, z);
  Surface shown =
      glazed(painted(Pattern::kScreen, 0x10281c, 0x40d080, 0x10281c, random.seed(), 0.05F));
  shown.size_m = {0.5F * size_m.x(), 0.62F * size_m.y()};
  shown.glow = 0.6F;
  add_quad(room.mesh, room.add(shown), front, {-0.9F * x, 0.22F * size_m.y(), 0.0015F},
           {shown.size_m.x(), 0, 0}, {0, shown.size_m.y(), 0});
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 3; ++column) {
      add_knob(room, front, dark, x * (0.28F + 0.27F * static_cast<float>(column)),
               size_m.y() * (0.35F + 0.33F * static_cast<float>(row)));
    }
  }
}

void add_lab_bench(Room& room, const Affine3f& at, SurfaceIndex top, SurfaceIndex metal,
                   const Vector3f& size_m, bool shelf) {
  const float x = 0.5F * size_m.x(), z = 0.5F * size_m.z(), h = size_m.y();
  add_box(room.mesh, top, at, {-x, h - 0.035F, -z}, {x, h, z});
  for (const float side : {-x + 0.05F, x - 0.05F}) {
    for (const float deep : {-z + 0.05F, z - 0.08F}) {
      add_box(room.mesh, metal, at, {side - 0.022F, 0, deep - 0.022F},
              {side + 0.022F, h - 0.035F, deep + 0.022F});
    }
    add_box(room.mesh, metal, at, {side - 0.015F, 0.10F, -z + 0.072F},
            {side + 0.015F, 0.14F, z - 0.102F});
  }
  add_box(room.mesh, metal, at, {-x + 0.072F, h - 0.10F, -z + 0.04F},
          {x - 0.072F, h - 0.035F, -z + 0.06F});
  if (!shelf) return;
  for (const float side : {-x + 0.03F, x - 0.03F}) {
    add_box(room.mesh, metal, at, {side - 0.015F, h, -z + 0.01F},
            {side + 0.015F, h + 0.62F, -z + 0.04F});
  }
  add_box(room.mesh, top, at, {-x, h + 0.44F, -z + 0.005F}, {x, h + 0.465F, -z + 0.30F});
}

void add_drawers(Room& room, const Affine3f& at, SurfaceIndex body, SurfaceIndex handles,
                 const Vector3f& size_m) {
  const float x = 0.5F * size_m.x(), z = 0.5F * size_m.z();
  add_box(room.mesh, body, at, {-x, 0.06F, -z}, {x, size_m.y(), z - 0.018F});
  for (const float side : {-0.7F * x, 0.7F * x}) {
    for (const float deep : {-0.7F * z, 0.6F * z}) {
      add_cushion(room.mesh, handles, at, {side, 0.03F, deep}, {0.03F, 0.03F, 0.03F}, 1.0F);
    }
  }
  const int drawers = std::max(2, static_cast<int>(size_m.y() / 0.19F));
  const float pitch = (size_m.y() - 0.07F) / static_cast<float>(drawers);
  for (int i = 0; i < drawers; ++i) {
    const float y = 0.065F + pitch * static_cast<float>(i);
    add_box(room.mesh, body, at, {-x + 0.006F, y, z - 0.018F}, {x - 0.006F, y + pitch - 0.008F, z});
    add_box(room.mesh, handles, at, {-0.06F, y + 0.6F * pitch, z},
            {0.06F, y + 0.6F * pitch + 0.012F, z + 0.018F});
  }
}

void add_rack(Room& room, const Affine3f& at, SurfaceIndex metal, const Vector3f& size_m,
              std::uint32_t seed) {
  Random random(seed);
  const float x = 0.5F * size_m.x(), z = 0.5F * size_m.z(), h = size_m.y();
  for (const float side : {-x, x - 0.04F}) {
    for (const float deep : {-z, z - 0.04F})
      add_box(room.mesh, metal, at, {side, 0, deep}, {side + 0.04F, h, deep + 0.04F});
  }
  add_box(room.mesh, metal, at, {-x, h, -z}, {x, h + 0.02F, z});
  add_box(room.mesh, metal, at, {-x + 0.04F, 0, -z + 0.04F}, {x - 0.04F, 0.04F, z - 0.04F});
  constexpr std::array<std::uint32_t, 4> kFaces = {0x2c2f34, 0x40454c, 0xb4b8bc, 0x1d2a3a};
  float y = 0.08F;
  while (y < h - 0.12F) {
    const float unit = 0.0445F * static_cast<float>(1 + random.below(4));
    if (y + unit > h - 0.04F) break;
    if (!random.chance(0.18F)) {
      const auto color = random.one_of(kFaces);
      Surface face = painted(Pattern::kRackFace, color, 0x101114, 0x08090a, random.seed(), 0.25F);
      face.size_m = {size_m.x() - 0.08F, unit - 0.004F};
      const float depth = random.between(0.25F, 0.9F * size_m.z());
      add_box(room.mesh, add_paint(room, color, random.seed(), 0.25F), at,
              {-x + 0.04F, y, z - 0.012F - depth}, {x - 0.04F, y + unit - 0.004F, z - 0.012F});
      add_quad(room.mesh, room.add(face), at, {-x + 0.04F, y, z - 0.010F}, {face.size_m.x(), 0, 0},
               {0, face.size_m.y(), 0});
    }
    y += unit;
  }
  constexpr std::array<std::uint32_t, 5> kCables = {0xd0a020, 0x2a5aa0, 0xb03030, 0x303236,
                                                    0xd8d8d8};
  for (int i = 0; i < 10; ++i) {
    const float from = random.between(0.15F, h - 0.3F);
    const float to = random.between(0.15F, h - 0.3F);
    const float left = random.between(-x + 0.08F, x - 0.08F);
    const float right = left + random.between(-0.15F, 0.15F);
    const float low = std::min(from, to) - random.between(0.02F, 0.12F);
    const std::array<Vector3f, 5> line = {Vector3f(left, from, z - 0.01F),
                                          {left, from - 0.02F, z + 0.03F},
                                          {0.5F * (left + right), low, z + 0.05F},
                                          {right, to - 0.02F, z + 0.03F},
                                          {right, to, z - 0.01F}};
    add_tube(room.mesh, add_paint(room, random.one_of(kCables), random.seed()), at, line, 0.004F);
  }
}

void add_cable_tray(Room& room, const Vector3f& from_m, const Vector3f& to_m, SurfaceIndex metal,
                    std::uint32_t seed) {
  Random random(seed);
  const Vector3f way = to_m - from_m;
  const float length = way.norm();
  const Affine3f at =
      Affine3f(Translation3f(from_m)) * AngleAxisf(std::atan2(way.x(), way.z()), Vector3f::UnitY());
  for (const float x : {-0.15F, 0.14F})
    add_box(room.mesh, metal, at, {x, 0, 0}, {x + 0.01F, 0.06F, length});
  for (float z = 0.12F; z < length; z += 0.3F)
    add_box(room.mesh, metal, at, {-0.14F, 0.005F, z}, {0.14F, 0.015F, z + 0.02F});
  for (float z = 0.4F; z < length; z += 1.4F) {
    for (const float x : {-0.145F, 0.145F}) {
      const std::array<Vector3f, 2> rod = {Vector3f(x, 0.05F, z),
                                           {x, room.size_m.y() - from_m.y(), z}};
      add_tube(room.mesh, metal, at, rod, 0.005F);
    }
  }
  constexpr std::array<std::uint32_t, 5> kCables = {0x1f2022, 0x2a5aa0, 0xd8d8d4, 0xd0a020,
                                                    0x3a3b3e};
  for (int i = 0; i < 9; ++i) {
    const float radius = random.between(0.005F, 0.011F);
    std::vector<Vector3f> line;
    const float home = -0.12F + 0.028F * static_cast<float>(i);
    for (float z = 0.0F; z <= length; z += 0.25F) {
      line.emplace_back(home + random.between(-0.008F, 0.008F),
                        0.016F + radius + random.between(0.0F, 0.006F), z);
    }
    add_tube(room.mesh, add_paint(room, random.one_of(kCables), random.seed(), 0.3F), at, line,
             radius);
  }
}

void add_cable_coil(Room& room, const Affine3f& at, SurfaceIndex surface, float radius_m) {
  std::vector<Vector3f> line;
  for (int i = 0; i <= 72; ++i) {
    const float angle = 0.35F * static_cast<float>(i);
    const float wobble = 1.0F + 0.08F * std::sin(2.3F * angle);
    line.emplace_back(radius_m * wobble * std::cos(angle), 0.008F + 0.0006F * static_cast<float>(i),
                      radius_m * wobble * std::sin(angle));
  }
  add_tube(room.mesh, surface, at, line, 0.006F);
}

void add_whiteboard(Room& room, const Affine3f& on_wall, SurfaceIndex frame, const Vector2f& size_m,
                    std::uint32_t seed) {
  Surface board = painted(Pattern::kDrawings, 0xf4f5f4, 0x1f3f8c, 0xa03030, seed, 0.6F);
  board.size_m = size_m;
  board.gloss = 0.04F;  // enamel, less smooth than glass
  board.polish = 1200.0F;
  add_picture(room, on_wall, frame, board);
  const float y = -0.5F * size_m.y() - 0.03F;
  add_box(room.mesh, frame, on_wall, {-0.25F * size_m.x(), y - 0.012F, 0},
          {0.25F * size_m.x(), y, 0.07F});
  constexpr std::array<std::uint32_t, 3> kPens = {0xb03030, 0x2040a0, 0x208040};
  for (std::size_t i = 0; i < kPens.size(); ++i) {
    const float x = -0.15F + 0.14F * static_cast<float>(i);
    const std::array<Vector3f, 2> pen = {Vector3f(x, y + 0.008F, 0.05F),
                                         {x + 0.12F, y + 0.008F, 0.045F}};
    add_tube(room.mesh, add_paint(room, kPens[i], seed + 9U), on_wall, pen, 0.008F);
  }
}

void add_wall_screen(Room& room, const Affine3f& on_wall, SurfaceIndex plastic,
                     const Vector2f& size_m, std::uint32_t seed) {
  const float x = 0.5F * size_m.x(), y = 0.5F * size_m.y();
  add_box(room.mesh, plastic, on_wall, {-0.3F, -0.2F, 0}, {0.3F, 0.2F, 0.04F});
  add_box(room.mesh, plastic, on_wall, {-x - 0.015F, -y - 0.015F, 0.04F},
          {x + 0.015F, y + 0.015F, 0.08F});
  Surface shown = glazed(painted(Pattern::kScreen, 0xe8ecf0, 0x2a4a6a, 0x1c2430, seed, 0.04F));
  shown.size_m = size_m;
  shown.glow = 0.75F;
  add_quad(room.mesh, room.add(shown), on_wall, {-x, -y, 0.082F}, {size_m.x(), 0, 0},
           {0, size_m.y(), 0});
}

}  // namespace roomcast::simulator
