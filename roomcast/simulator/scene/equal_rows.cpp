// SPDX-License-Identifier: Apache-2.0
// Rows of equal furniture: a store of shelves, a classroom of desks. A pose that is off by a row or
// by a place fits nearly as well as the true one.
#include "roomcast/simulator/scene/empty_room.h"
#include "roomcast/simulator/scene/furnisher.h"
#include "roomcast/simulator/scene/routes.h"
#include "roomcast/simulator/scene/scenes.h"

namespace roomcast::simulator {
namespace {

using Eigen::Affine3f;
using Eigen::Vector3f;

constexpr float kHalfAisle_m = 0.55F;  // the aisle along the x axis, through the room's centre

/// Equal pieces on both sides of the aisle, `rows` on each, all facing the same way.
struct RowPlan {
  int rows, per_row;
  Vector3f piece_m;  // the place of one piece
  float pitch_x_m, pitch_z_m;
};

template <class Add>
void fill_rows(const RowPlan& rows, FloorPlan& plan, const Add& add) {
  for (int row = 0; row < rows.rows; ++row) {
    const float out_m =
        kHalfAisle_m + 0.5F * rows.piece_m.z() + rows.pitch_z_m * static_cast<float>(row);
    for (const float side : {-1.0F, 1.0F}) {
      for (int i = 0; i < rows.per_row; ++i) {
        const float middle = 0.5F * static_cast<float>(rows.per_row - 1);
        const Affine3f at =
            standing_at(rows.pitch_x_m * (static_cast<float>(i) - middle), side * out_m);
        if (plan.take(at, rows.piece_m)) add(at);
      }
    }
  }
}

/// Walks up and down the aisle.
void add_aisle_walker(Room& room, FloorPlan& plan, Random& random, float half_way_m) {
  Person walker = draw_person(room, random);
  walker.stops = {Waypoint{}, Waypoint{}};
  walker.stops[0].at_m = {-half_way_m, 0};
  walker.stops[1].at_m = {half_way_m, 0};
  walker.stops[0].heading_rad = 0.5F * 3.14159265F;
  walker.stops[1].heading_rad = -0.5F * 3.14159265F;
  room.people.push_back(walker);
  plan.keep_way(walker.stops[0].at_m, walker.stops[1].at_m, 0.4F);
}

/// What is on the walls, as in any room of the kind.
void finish_walls(Room& room, FloorPlan& plan, Furnisher& furnisher, Random& random) {
  furnisher.door();
  if (random.chance(0.5F)) furnisher.window();
  furnisher.pictures(1 + random.below(3));
  room.footprints = plan.taken();
}

}  // namespace

std::optional<Room> try_shelf_rows(std::uint32_t seed) {
  Random random(seed);
  Room room = empty_room({random.between(5.8F, 6.6F), 2.9F, random.between(5.2F, 5.8F)},
                         {0.45F, 0.45F, 0.46F}, draw_sensor_mounts_around, random);
  FloorPlan plan = plan_of(room, random);
  add_plain_shell(room, random.chance(0.5F) ? FloorKind::kConcrete : FloorKind::kTerrazzo, random);
  Furnisher furnisher(room, plan, random);
  furnisher.panels();
  add_aisle_walker(room, plan, random, 1.6F);
  const Vector3f shelf(random.between(0.8F, 1.0F), random.between(0.95F, 1.2F), 0.32F);
  const std::uint32_t books = random.seed();
  fill_rows(
      {2, 3, shelf, shelf.x() + 0.04F, random.between(0.95F, 1.15F)}, plan,
      [&](const Affine3f& at) { add_bookshelf(room, at, furnisher.palette().wood, shelf, books); });
  finish_walls(room, plan, furnisher, random);
  return room;
}

std::optional<Room> try_desk_rows(std::uint32_t seed) {
  Random random(seed);
  Room room = empty_room({random.between(5.8F, 6.6F), 2.8F, random.between(5.0F, 5.6F)},
                         {0.46F, 0.46F, 0.45F}, draw_sensor_mounts_in_corners, random);
  FloorPlan plan = plan_of(room, random);
  add_plain_shell(room, random.chance(0.5F) ? FloorKind::kCarpet : FloorKind::kBoards, random);
  Furnisher furnisher(room, plan, random);
  furnisher.panels();
  add_aisle_walker(room, plan, random, 1.6F);
  const float width = random.between(1.1F, 1.3F);
  const std::uint32_t laptop = random.seed();
  fill_rows({1, 4, {width, 1.15F, 1.30F}, width + random.between(0.15F, 0.3F), 0}, plan,
            [&](const Affine3f& at) {
              const Affine3f desk = moved(at, {0, 0, -0.28F});
              add_table(room, desk, furnisher.palette().wood, {width, 0.73F, 0.65F});
              add_laptop(room, moved(desk, {0, 0.73F, 0}), laptop);
              add_shell_chair(room, moved(at, {0, 0, 0.32F}, 3.14159265F),
                              furnisher.palette().cloth, furnisher.palette().metal);
            });
  furnisher.whiteboard(0.0F);
  finish_walls(room, plan, furnisher, random);
  return room;
}

}  // namespace roomcast::simulator
