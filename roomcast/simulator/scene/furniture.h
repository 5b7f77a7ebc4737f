// SPDX-License-Identifier: Apache-2.0
// Adds furniture to a room's mesh. Each piece is on the local floor (y = 0) with its centre at the
// local origin and its front towards local +z. Metres.
#pragma once

#include <cstdint>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "roomcast/simulator/scene/room.h"

namespace roomcast::simulator {

/// Frame on the floor at (x, z); a positive yaw turns its front from +z towards +x.
[[nodiscard]] Eigen::Affine3f standing_at(float x_m, float z_m, float yaw_rad = 0.0F);

/// The frame, translated along its own axes and then rotated about the vertical.
[[nodiscard]] Eigen::Affine3f moved(const Eigen::Affine3f& at, const Eigen::Vector3f& by_m,
                                    float yaw_rad = 0.0F);

/// A plain surface of one colour.
SurfaceIndex add_paint(Room& room, std::uint32_t color, std::uint32_t seed, float infrared = 0.5F);

/// Adds floor, ceiling, four walls and skirting boards for the room's size. Walls in order -x, +x,
/// -z, +z.
struct ShellSurfaces {
  SurfaceIndex floor, ceiling, skirting;
  std::array<SurfaceIndex, 4> walls;
};
void add_shell(Room& room, const ShellSurfaces& surfaces);

void add_table(Room& room, const Eigen::Affine3f& at, SurfaceIndex wood,
               const Eigen::Vector3f& size_m);
void add_chair(Room& room, const Eigen::Affine3f& at, SurfaceIndex wood, SurfaceIndex seat);
void add_sofa(Room& room, const Eigen::Affine3f& at, SurfaceIndex cloth, SurfaceIndex wood,
              float width_m);
void add_throw_cushion(Room& room, const Eigen::Affine3f& at, SurfaceIndex cloth,
                       const Eigen::Vector3f& centre_m, float lean_rad);
void add_bookshelf(Room& room, const Eigen::Affine3f& at, SurfaceIndex wood,
                   const Eigen::Vector3f& size_m, std::uint32_t seed);
/// A row of books along +x from the local origin, up to `width_m`.
void add_book_row(Room& room, const Eigen::Affine3f& at, float width_m, float height_m,
                  std::uint32_t seed);
void add_plant(Room& room, const Eigen::Affine3f& at, std::uint32_t seed);
void add_floor_lamp(Room& room, const Eigen::Affine3f& at, SurfaceIndex metal, SurfaceIndex shade);
/// Three legs and a column with a plate on top, at the given height.
void add_tripod(Room& room, const Eigen::Affine3f& at, SurfaceIndex metal, float height_m);
void add_pendant_lamp(Room& room, const Eigen::Vector3f& ceiling_point_m, SurfaceIndex cord,
                      SurfaceIndex shade);
void add_sideboard(Room& room, const Eigen::Affine3f& at, SurfaceIndex wood, SurfaceIndex handles,
                   const Eigen::Vector3f& size_m);
void add_office_chair(Room& room, const Eigen::Affine3f& at, SurfaceIndex cloth,
                      SurfaceIndex plastic);
void add_monitor(Room& room, const Eigen::Affine3f& at, SurfaceIndex plastic,
                 const Surface& screen);

void add_round_table(Room& room, const Eigen::Affine3f& at, SurfaceIndex wood, float radius_m,
                     float height_m);
void add_stool(Room& room, const Eigen::Affine3f& at, SurfaceIndex wood, SurfaceIndex seat);
void add_shell_chair(Room& room, const Eigen::Affine3f& at, SurfaceIndex shell, SurfaceIndex metal);
void add_bin(Room& room, const Eigen::Affine3f& at, SurfaceIndex surface);
void add_bicycle(Room& room, const Eigen::Affine3f& at, std::uint32_t seed);

// Objects on tables and shelves; the local origin is on the table top.
void add_table_lamp(Room& room, const Eigen::Affine3f& at, SurfaceIndex base, SurfaceIndex shade);
void add_mug(Room& room, const Eigen::Affine3f& at, SurfaceIndex glaze);
void add_book_stack(Room& room, const Eigen::Affine3f& at, int count, std::uint32_t seed);
void add_fruit_bowl(Room& room, const Eigen::Affine3f& at, std::uint32_t seed);
void add_keyboard(Room& room, const Eigen::Affine3f& at, std::uint32_t seed);
void add_laptop(Room& room, const Eigen::Affine3f& at, std::uint32_t seed);
void add_instrument(Room& room, const Eigen::Affine3f& at, const Eigen::Vector3f& size_m,
                    std::uint32_t seed);
void add_cable_coil(Room& room, const Eigen::Affine3f& at, SurfaceIndex surface, float radius_m);

// Laboratory.
void add_lab_bench(Room& room, const Eigen::Affine3f& at, SurfaceIndex top, SurfaceIndex metal,
                   const Eigen::Vector3f& size_m, bool shelf);
void add_drawers(Room& room, const Eigen::Affine3f& at, SurfaceIndex body, SurfaceIndex handles,
                 const Eigen::Vector3f& size_m);
void add_rack(Room& room, const Eigen::Affine3f& at, SurfaceIndex metal,
              const Eigen::Vector3f& size_m, std::uint32_t seed);
/// Hangs from the ceiling, between two points at the same height.
void add_cable_tray(Room& room, const Eigen::Vector3f& from_m, const Eigen::Vector3f& to_m,
                    SurfaceIndex metal, std::uint32_t seed);

/// Objects on a wall: the local frame's xy plane is the wall, +z points into the room, the origin
/// is the picture's centre.
void add_picture(Room& room, const Eigen::Affine3f& on_wall, SurfaceIndex frame, Surface painting);
void add_window(Room& room, const Eigen::Affine3f& on_wall, SurfaceIndex frame, const Surface& view,
                SurfaceIndex curtain);
void add_door(Room& room, const Eigen::Affine3f& on_wall, SurfaceIndex wood, SurfaceIndex metal);
void add_radiator(Room& room, const Eigen::Affine3f& on_wall, SurfaceIndex metal, float width_m);
void add_clock(Room& room, const Eigen::Affine3f& on_wall, SurfaceIndex rim, const Surface& dial);
void add_whiteboard(Room& room, const Eigen::Affine3f& on_wall, SurfaceIndex frame,
                    const Eigen::Vector2f& size_m, std::uint32_t seed);
void add_wall_screen(Room& room, const Eigen::Affine3f& on_wall, SurfaceIndex plastic,
                     const Eigen::Vector2f& size_m, std::uint32_t seed);

/// Local frame at a wall point: 0: -x, 1: +x, 2: -z, 3: +z; `along_m` is the world z (walls 0, 1)
/// or x (2, 3).
[[nodiscard]] Eigen::Affine3f on_wall(const Room& room, int wall, float along_m, float height_m);

}  // namespace roomcast::simulator
