// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <vector>

#include "roomcast/simulator/random/value_noise.h"
#include "roomcast/simulator/scene/furniture.h"

namespace roomcast::simulator {
namespace {

using Eigen::Affine3f;
using Eigen::AngleAxisf;
using Eigen::Vector2f;
using Eigen::Vector3f;

void add_legs(Room& room, const Affine3f& at, SurfaceIndex surface, const Vector2f& half_spread_m,
              float thickness_m, float height_m) {
  const float half = 0.5F * thickness_m;
  for (const float x : {-half_spread_m.x(), half_spread_m.x()}) {
    for (const float z : {-half_spread_m.y(), half_spread_m.y()}) {
      add_box(room.mesh, surface, at, {x - half, 0, z - half}, {x + half, height_m, z + half});
    }
  }
}

Affine3f turned(const Affine3f& at, const Vector3f& shift_m, float yaw_rad,
                float pitch_rad = 0.0F) {
  return at * Eigen::Translation3f(shift_m) * AngleAxisf(yaw_rad, Vector3f::UnitY()) *
         AngleAxisf(pitch_rad, Vector3f::UnitX());
}

}  // namespace

Eigen::Affine3f moved(const Eigen::Affine3f& at, const Eigen::Vector3f& by_m, float yaw_rad) {
  return at * Eigen::Translation3f(by_m) * Eigen::AngleAxisf(yaw_rad, Eigen::Vector3f::UnitY());
}

SurfaceIndex add_paint(Room& room, std::uint32_t color, std::uint32_t seed, float infrared) {
  return room.add(painted(Pattern::kPlain, color, 0, 0, seed, infrared));
}

Affine3f standing_at(float x_m, float z_m, float yaw_rad) {
  return turned(Affine3f::Identity(), {x_m, 0, z_m}, yaw_rad);
}

void add_table(Room& room, const Affine3f& at, SurfaceIndex wood, const Vector3f& size_m) {
  const float x = 0.5F * size_m.x();
  const float z = 0.5F * size_m.z();
  const float top = size_m.y();
  add_box(room.mesh, wood, at, {-x, top - 0.035F, -z}, {x, top, z});
  add_box(room.mesh, wood, at, {-x + 0.06F, top - 0.11F, -z + 0.05F},
          {x - 0.06F, top - 0.035F, -z + 0.07F});
  add_box(room.mesh, wood, at, {-x + 0.06F, top - 0.11F, z - 0.07F},
          {x - 0.06F, top - 0.035F, z - 0.05F});
  add_legs(room, at, wood, {x - 0.07F, z - 0.07F}, 0.06F, top - 0.035F);
}

void add_chair(Room& room, const Affine3f& at, SurfaceIndex wood, SurfaceIndex seat) {
  add_legs(room, at, wood, {0.19F, 0.19F}, 0.04F, 0.44F);
  add_cushion(room.mesh, seat, at, {0, 0.465F, 0}, {0.225F, 0.035F, 0.22F}, 0.35F);
  for (const float x : {-0.19F, 0.19F}) {
    add_box(room.mesh, wood, at, {x - 0.02F, 0.44F, -0.21F}, {x + 0.02F, 0.95F, -0.175F});
  }
  for (const float y : {0.62F, 0.74F, 0.86F}) {
    add_box(room.mesh, wood, at, {-0.19F, y, -0.205F}, {0.19F, y + 0.06F, -0.185F});
  }
}

void add_sofa(Room& room, const Affine3f& at, SurfaceIndex cloth, SurfaceIndex wood,
              float width_m) {
  const float x = 0.5F * width_m;
  add_legs(room, at, wood, {x - 0.1F, 0.33F}, 0.05F, 0.12F);
  add_cushion(room.mesh, cloth, at, {0, 0.22F, 0}, {x, 0.11F, 0.43F}, 0.2F);
  add_cushion(room.mesh, cloth, at, {0, 0.50F, -0.35F}, {x, 0.33F, 0.10F}, 0.35F);
  for (const float side : {-1.0F, 1.0F}) {
    add_cushion(room.mesh, cloth, at, {side * (x - 0.10F), 0.38F, 0}, {0.11F, 0.25F, 0.43F}, 0.4F);
  }
  const int seats = std::max(1, static_cast<int>((width_m - 0.42F) / 0.52F));
  const float seat_width = (width_m - 0.42F) / static_cast<float>(seats);
  for (int i = 0; i < seats; ++i) {
    const float middle = -x + 0.21F + seat_width * (static_cast<float>(i) + 0.5F);
    add_cushion(room.mesh, cloth, at, {middle, 0.40F, 0.07F}, {0.495F * seat_width, 0.085F, 0.36F},
                0.35F);
    add_cushion(room.mesh, cloth, turned(at, {middle, 0.66F, -0.21F}, 0, -0.18F), Vector3f::Zero(),
                {0.485F * seat_width, 0.22F, 0.10F}, 0.5F);
  }
}

void add_throw_cushion(Room& room, const Affine3f& at, SurfaceIndex cloth, const Vector3f& centre_m,
                       float lean_rad) {
  add_cushion(room.mesh, cloth, turned(at, centre_m, 0.6F * lean_rad, -std::abs(lean_rad)),
              Vector3f::Zero(), {0.21F, 0.21F, 0.075F}, 0.6F);
}

void add_book_row(Room& room, const Affine3f& at, float width_m, float height_m,
                  std::uint32_t seed) {
  constexpr std::array<std::uint32_t, 10> kCovers = {0x8c2f2b, 0x24476b, 0x2f5d3a, 0xc9a24a,
                                                     0xe6ddc8, 0x4a3555, 0x1f1f24, 0xb8552f,
                                                     0x6d8f9c, 0xd9d4cc};
  float x = 0.0F;
  for (std::uint32_t i = 0; x < width_m - 0.03F; ++i) {
    const auto hash = hash_of(seed, i);
    const float thickness = std::min(0.018F + 0.035F * unit_from_hash(hash), width_m - x);
    const float height = height_m * (0.68F + 0.27F * nth_unit(hash, 3U));
    const float depth = 0.15F + 0.06F * nth_unit(hash, 5U);
    if (hash % 11U != 0U) {  // occasional gap
      Surface cover;
      cover.pattern = Pattern::kBookSpine;
      cover.base = linear_from_srgb(kCovers[hash % kCovers.size()]);
      cover.accent = linear_from_srgb(kCovers[(hash >> 8) % kCovers.size()]);
      cover.trim = linear_from_srgb((hash & 4096U) != 0U ? 0xf0e8d0 : 0x20201c);
      cover.size_m = {thickness, height};
      cover.seed = hash;
      const auto spine = room.add(cover);
      cover.pattern = Pattern::kPlain;
      const auto sides = room.add(cover);
      add_box(room.mesh, sides, at, {x, 0, -depth}, {x + thickness - 0.001F, height, -0.001F});
      add_quad(room.mesh, spine, at, {x, 0, 0}, {thickness - 0.001F, 0, 0}, {0, height, 0});
    }
    x += thickness;
  }
}

void add_bookshelf(Room& room, const Affine3f& at, SurfaceIndex wood, const Vector3f& size_m,
                   std::uint32_t seed) {
  const float x = 0.5F * size_m.x();
  const float back = -0.5F * size_m.z();
  const float front = 0.5F * size_m.z();
  add_box(room.mesh, wood, at, {-x, 0, back}, {-x + 0.025F, size_m.y(), front});
  add_box(room.mesh, wood, at, {x - 0.025F, 0, back}, {x, size_m.y(), front});
  add_box(room.mesh, wood, at, {-x, 0, back}, {x, size_m.y(), back + 0.012F});
  const int shelves = static_cast<int>(size_m.y() / 0.36F);
  const float pitch = (size_m.y() - 0.08F) / static_cast<float>(shelves);
  for (int i = 0; i <= shelves; ++i) {
    const float y = 0.06F + pitch * static_cast<float>(i);
    add_box(room.mesh, wood, at, {-x, y - 0.022F, back}, {x, y, front});
    if (i == shelves) break;
    const auto row_seed = hash_of(seed, static_cast<std::uint32_t>(i));
    const float filled = (size_m.x() - 0.06F) * (0.6F + 0.4F * unit_from_hash(row_seed));
    add_book_row(room, turned(at, {-x + 0.03F, y, front - 0.04F}, 0), filled, pitch - 0.03F,
                 row_seed);
  }
}

void add_plant(Room& room, const Affine3f& at, std::uint32_t seed) {
  Surface pot;
  pot.base = linear_from_srgb(0xb5653f);
  pot.seed = seed;
  const std::array<Vector2f, 6> profile = {Vector2f(0, 0),  {0.12F, 0},      {0.17F, 0.30F},
                                           {0.185F, 0.30F}, {0.185F, 0.33F}, {0, 0.30F}};
  add_turned(room.mesh, room.add(pot), at, profile);
  Surface green;
  green.pattern = Pattern::kLeaf;
  green.base = linear_from_srgb(0x1f5a2a);
  green.accent = linear_from_srgb(0x5d9a3f);
  green.trim = linear_from_srgb(0xb9d08a);
  green.infrared = 0.6F;
  for (std::uint32_t i = 0; i < 34U; ++i) {
    const auto hash = hash_of(seed, i + 5U);
    green.seed = hash;
    const float stem = 0.34F + 0.55F * unit_from_hash(hash);
    const float yaw = 2.4F * static_cast<float>(i) + nth_unit(hash, 2U);
    const float size = 0.26F + 0.16F * nth_unit(hash, 4U);
    add_leaf(room.mesh, room.add(green), turned(at, {0, stem, 0}, yaw), size, 0.42F * size,
             0.5F + 0.9F * nth_unit(hash, 6U));
  }
  const std::array<Vector2f, 2> stem_profile = {Vector2f(0.014F, 0.3F), {0.006F, 0.9F}};
  add_turned(room.mesh, room.add(green), at, stem_profile);
}

void add_floor_lamp(Room& room, const Affine3f& at, SurfaceIndex metal, SurfaceIndex shade) {
  const std::array<Vector2f, 5> stand = {
      Vector2f(0.15F, 0), {0.15F, 0.02F}, {0.014F, 0.03F}, {0.012F, 1.45F}, {0, 1.45F}};
  add_turned(room.mesh, metal, at, stand);
  const std::array<Vector2f, 2> cone = {Vector2f(0.21F, 1.28F), {0.13F, 1.55F}};
  add_turned(room.mesh, shade, at, cone);
}

void add_tripod(Room& room, const Affine3f& at, SurfaceIndex metal, float height_m) {
  constexpr float kThird = 2.0943951F;
  const float joint_m = 0.72F * height_m;
  for (int leg = 0; leg < 3; ++leg) {
    const float angle = kThird * static_cast<float>(leg);
    const std::array<Vector3f, 2> line = {
        Vector3f(0.30F * std::sin(angle), 0.0F, 0.30F * std::cos(angle)),
        Vector3f(0.02F * std::sin(angle), joint_m, 0.02F * std::cos(angle))};
    add_tube(room.mesh, metal, at, line, 0.011F);
  }
  const std::array<Vector2f, 7> column = {Vector2f(0, 0.4F * height_m), {0.012F, 0.4F * height_m},
                                          {0.012F, joint_m - 0.04F},    {0.035F, joint_m - 0.03F},
                                          {0.035F, joint_m + 0.02F},    {0.012F, joint_m + 0.03F},
                                          {0.012F, height_m - 0.02F}};
  add_turned(room.mesh, metal, at, column);
  add_box(room.mesh, metal, at, {-0.06F, height_m - 0.02F, -0.05F}, {0.06F, height_m, 0.05F});
}

void add_pendant_lamp(Room& room, const Vector3f& ceiling_point_m, SurfaceIndex cord,
                      SurfaceIndex shade) {
  const Affine3f at(Eigen::Translation3f{ceiling_point_m});
  const std::array<Vector2f, 4> wire = {
      Vector2f(0.004F, -0.30F), {0.004F, -0.02F}, {0.05F, -0.02F}, {0.05F, 0}};
  add_turned(room.mesh, cord, at, wire);
  const std::array<Vector2f, 5> dome = {
      Vector2f(0.20F, -0.46F), {0.19F, -0.40F}, {0.13F, -0.33F}, {0.05F, -0.30F}, {0, -0.29F}};
  add_turned(room.mesh, shade, at, dome);
}

void add_sideboard(Room& room, const Affine3f& at, SurfaceIndex wood, SurfaceIndex handles,
                   const Vector3f& size_m) {
  const float x = 0.5F * size_m.x();
  const float z = 0.5F * size_m.z();
  add_legs(room, at, handles, {x - 0.08F, z - 0.06F}, 0.035F, 0.12F);
  add_box(room.mesh, wood, at, {-x, 0.12F, -z}, {x, size_m.y(), z - 0.02F});
  const int doors = std::max(2, static_cast<int>(size_m.x() / 0.45F));
  const float width = size_m.x() / static_cast<float>(doors);
  for (int i = 0; i < doors; ++i) {
    const float left = -x + width * static_cast<float>(i);
    add_box(room.mesh, wood, at, {left + 0.004F, 0.13F, z - 0.02F},
            {left + width - 0.004F, size_m.y() - 0.01F, z});
    const float knob = left + (i % 2 == 0 ? width - 0.06F : 0.06F);
    add_box(room.mesh, handles, at, {knob - 0.008F, 0.5F * size_m.y(), z},
            {knob + 0.008F, 0.5F * size_m.y() + 0.12F, z + 0.02F});
  }
}

void add_office_chair(Room& room, const Affine3f& at, SurfaceIndex cloth, SurfaceIndex plastic) {
  for (int i = 0; i < 5; ++i) {
    const Affine3f spoke = turned(at, Vector3f::Zero(), 1.2566F * static_cast<float>(i));
    add_box(room.mesh, plastic, spoke, {-0.025F, 0.06F, 0}, {0.025F, 0.10F, 0.30F});
    add_cushion(room.mesh, plastic, spoke, {0, 0.03F, 0.29F}, {0.02F, 0.03F, 0.03F}, 1.0F);
  }
  const std::array<Vector2f, 2> post = {Vector2f(0.03F, 0.09F), {0.025F, 0.42F}};
  add_turned(room.mesh, plastic, at, post);
  add_cushion(room.mesh, cloth, at, {0, 0.46F, 0}, {0.25F, 0.05F, 0.24F}, 0.4F);
  add_cushion(room.mesh, cloth, turned(at, {0, 0.80F, -0.24F}, 0, -0.12F), Vector3f::Zero(),
              {0.22F, 0.28F, 0.04F}, 0.45F);
  for (const float x : {-0.28F, 0.28F}) {
    add_box(room.mesh, plastic, at, {x - 0.025F, 0.64F, -0.12F}, {x + 0.025F, 0.67F, 0.14F});
    add_box(room.mesh, plastic, at, {x - 0.015F, 0.45F, -0.03F}, {x + 0.015F, 0.64F, 0.02F});
  }
}

}  // namespace roomcast::simulator
