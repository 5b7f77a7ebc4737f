// SPDX-License-Identifier: Apache-2.0
// The room's shell, and objects on walls or desks.
#include <array>
#include <cmath>
#include <numbers>

#include "roomcast/simulator/scene/furniture.h"

namespace roomcast::simulator {
namespace {

using Eigen::Affine3f;
using Eigen::AngleAxisf;
using Eigen::Vector2f;
using Eigen::Vector3f;

/// Four bars on the wall that form a rectangle around the local origin.
void add_frame(Room& room, const Affine3f& at, SurfaceIndex surface, const Vector2f& inner_m,
               float bar_m, float thickness_m) {
  const float x = 0.5F * inner_m.x();
  const float y = 0.5F * inner_m.y();
  add_box(room.mesh, surface, at, {-x - bar_m, -y - bar_m, 0}, {-x, y + bar_m, thickness_m});
  add_box(room.mesh, surface, at, {x, -y - bar_m, 0}, {x + bar_m, y + bar_m, thickness_m});
  add_box(room.mesh, surface, at, {-x, y, 0}, {x, y + bar_m, thickness_m});
  add_box(room.mesh, surface, at, {-x, -y - bar_m, 0}, {x, -y, thickness_m});
}

void add_centred_quad(Room& room, const Affine3f& at, SurfaceIndex surface, const Vector2f& size_m,
                      float out_m) {
  add_quad(room.mesh, surface, at, {-0.5F * size_m.x(), -0.5F * size_m.y(), out_m},
           {size_m.x(), 0, 0}, {0, size_m.y(), 0});
}

void add_skirting(Room& room, SurfaceIndex surface) {
  for (int wall = 0; wall < 4; ++wall) {
    const float half = 0.5F * (wall < 2 ? room.size_m.z() : room.size_m.x());
    add_box(room.mesh, surface, on_wall(room, wall, 0, 0), {-half, 0, 0}, {half, 0.07F, 0.012F});
  }
}

}  // namespace

Affine3f on_wall(const Room& room, int wall, float along_m, float height_m) {
  constexpr float kQuarter = 0.5F * std::numbers::pi_v<float>;
  const float x = 0.5F * room.size_m.x();
  const float z = 0.5F * room.size_m.z();
  const std::array<Vector3f, 4> point = {
      Vector3f(-x, height_m, along_m), Vector3f(x, height_m, along_m),
      Vector3f(along_m, height_m, -z), Vector3f(along_m, height_m, z)};
  const std::array<float, 4> yaw = {kQuarter, -kQuarter, 0.0F, 2.0F * kQuarter};
  const auto index = static_cast<std::size_t>(wall);
  return Affine3f(Eigen::Translation3f(point[index]) * AngleAxisf(yaw[index], Vector3f::UnitY()));
}

void add_shell(Room& room, const ShellSurfaces& surfaces) {
  const Vector3f s = room.size_m;
  const Affine3f corner(Eigen::Translation3f(-0.5F * s.x(), 0, -0.5F * s.z()));
  add_quad(room.mesh, surfaces.floor, corner, {0, 0, s.z()}, {s.x(), 0, 0}, {0, 0, -s.z()});
  add_quad(room.mesh, surfaces.ceiling, corner, {0, s.y(), 0}, {s.x(), 0, 0}, {0, 0, s.z()});
  for (int wall = 0; wall < 4; ++wall) {
    const float width = wall < 2 ? s.z() : s.x();
    add_quad(room.mesh, surfaces.walls[static_cast<std::size_t>(wall)], on_wall(room, wall, 0, 0),
             {-0.5F * width, 0, 0}, {width, 0, 0}, {0, s.y(), 0});
  }
  add_skirting(room, surfaces.skirting);
}

void add_picture(Room& room, const Affine3f& on_wall, SurfaceIndex frame, Surface painting) {
  add_frame(room, on_wall, frame, painting.size_m, 0.03F, 0.025F);
  const Vector2f size = painting.size_m;
  add_centred_quad(room, on_wall, room.add(painting), size, 0.012F);
}

void add_window(Room& room, const Affine3f& on_wall, SurfaceIndex frame, const Surface& view,
                SurfaceIndex curtain) {
  const Vector2f size = view.size_m;
  add_centred_quad(room, on_wall, room.add(view), size, 0.01F);
  add_frame(room, on_wall, frame, size, 0.06F, 0.04F);
  add_box(room.mesh, frame, on_wall, {-0.025F, -0.5F * size.y(), 0},
          {0.025F, 0.5F * size.y(), 0.035F});
  const float sill = -0.5F * size.y() - 0.06F;
  add_box(room.mesh, frame, on_wall, {-0.5F * size.x() - 0.1F, sill - 0.03F, 0},
          {0.5F * size.x() + 0.1F, sill, 0.16F});
  const float drop = size.y() + 0.55F;
  for (const float side : {-1.0F, 1.0F}) {
    const float left = side < 0 ? -0.5F * size.x() - 0.38F : 0.5F * size.x() - 0.02F;
    const Affine3f hung =
        on_wall * Eigen::Translation3f(left, 0.5F * size.y() + 0.18F - drop, 0.10F);
    add_curtain(room.mesh, curtain, hung, {0.40F, drop}, 0.035F, 5);
  }
  add_box(room.mesh, frame, on_wall, {-0.5F * size.x() - 0.45F, 0.5F * size.y() + 0.17F, 0.09F},
          {0.5F * size.x() + 0.45F, 0.5F * size.y() + 0.19F, 0.11F});
}

void add_door(Room& room, const Affine3f& on_wall, SurfaceIndex wood, SurfaceIndex metal) {
  const Affine3f middle = on_wall * Eigen::Translation3f(0, 1.035F, 0);
  add_frame(room, middle, wood, {0.86F, 1.93F}, 0.07F, 0.03F);
  add_box(room.mesh, wood, on_wall, {-0.43F, 0, 0}, {0.43F, 2.0F, 0.015F});
  for (const float x : {-0.19F, 0.19F}) {
    for (const float y : {0.5F, 1.45F}) {
      const Affine3f panel = on_wall * Eigen::Translation3f(x, y, 0.012F);
      add_frame(room, panel, wood, {0.20F, y < 1.0F ? 0.5F : 0.75F}, 0.025F, 0.016F);
    }
  }
  add_box(room.mesh, metal, on_wall, {-0.36F, 1.02F, 0.015F}, {-0.24F, 1.04F, 0.06F});
}

void add_radiator(Room& room, const Affine3f& on_wall, SurfaceIndex metal, float width_m) {
  for (float x = -0.5F * width_m; x < 0.5F * width_m; x += 0.065F) {
    add_cushion(room.mesh, metal, on_wall, {x + 0.03F, 0.42F, 0.07F}, {0.027F, 0.29F, 0.045F},
                0.3F);
  }
}

void add_clock(Room& room, const Affine3f& on_wall, SurfaceIndex rim, const Surface& dial) {
  const Affine3f facing = on_wall * AngleAxisf(0.5F * std::numbers::pi_v<float>, Vector3f::UnitX());
  const std::array<Vector2f, 4> ring = {
      Vector2f(0.17F, 0), {0.17F, 0.035F}, {0.15F, 0.035F}, {0.15F, 0.012F}};
  add_turned(room.mesh, rim, facing, ring);
  const std::array<Vector2f, 2> disc = {Vector2f(0.15F, 0.015F), {0, 0.015F}};
  add_turned(room.mesh, room.add(dial), facing, disc);
  add_box(room.mesh, rim, on_wall, {-0.006F, 0, 0.016F}, {0.006F, 0.12F, 0.019F});
  add_box(room.mesh, rim, on_wall, {0, -0.006F, 0.016F}, {0.08F, 0.006F, 0.019F});
}

void add_monitor(Room& room, const Affine3f& at, SurfaceIndex plastic, const Surface& screen) {
  const Vector2f size = screen.size_m;
  const Affine3f head = at * Eigen::Translation3f(0, 0.13F + 0.5F * size.y(), 0);
  add_box(room.mesh, plastic, at, {-0.11F, 0, -0.09F}, {0.11F, 0.012F, 0.08F});
  add_box(room.mesh, plastic, at, {-0.03F, 0, -0.045F}, {0.03F, 0.13F + 0.5F * size.y(), -0.025F});
  add_box(room.mesh, plastic, head, {-0.5F * size.x() - 0.012F, -0.5F * size.y() - 0.012F, -0.025F},
          {0.5F * size.x() + 0.012F, 0.5F * size.y() + 0.012F, 0.008F});
  add_centred_quad(room, head, room.add(screen), size, 0.009F);
}

}  // namespace roomcast::simulator
