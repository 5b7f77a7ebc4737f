// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vector>

#include "roomcast/simulator/scene/empty_room.h"
#include "roomcast/simulator/scene/furnisher.h"
#include "roomcast/simulator/scene/routes.h"
#include "roomcast/simulator/scene/scenes.h"

namespace roomcast::simulator {
namespace {

using Eigen::Affine3f;
using Eigen::Translation3f;
using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kChairHeight_m = 0.47F;
constexpr float kFromEdge_m = 0.30F;  // of the table to the centre of a chair

struct Table {
  Affine3f at;
  Vector3f size_m;
  std::vector<Affine3f> chairs;
};

/// A table on two feet with rounded corners, and chairs along its long sides.
std::optional<Table> add_meeting_table(Room& room, FloorPlan& plan, const Palette& palette,
                                       const Vector2f& middle_m, float yaw_rad, Random& random) {
  Table table;
  table.size_m = {random.between(1.9F, 2.5F), 0.74F, random.between(0.95F, 1.15F)};
  table.at = standing_at(middle_m.x(), middle_m.y(), yaw_rad);
  if (!plan.take(table.at, table.size_m + Vector3f(0.1F, 0.3F, 1.35F))) return std::nullopt;
  const float x = 0.5F * table.size_m.x();
  add_cushion(room.mesh, palette.wood, table.at, {0, 0.722F, 0},
              {x, 0.018F, 0.5F * table.size_m.z()}, 0.22F);
  for (const float side : {-0.6F * x, 0.6F * x}) {
    const std::array<Vector2f, 6> foot = {Vector2f(0, 0), {0.28F, 0},      {0.27F, 0.025F},
                                          {0.06F, 0.05F}, {0.045F, 0.65F}, {0.16F, 0.706F}};
    add_turned(room.mesh, palette.metal, table.at * Translation3f(side, 0, 0), foot);
  }
  const int per_side = table.size_m.x() > 2.2F ? 3 : 2;
  for (const float side : {-1.0F, 1.0F}) {
    for (int i = 0; i < per_side; ++i) {
      const float along = (static_cast<float>(i) + 0.5F) / static_cast<float>(per_side) - 0.5F;
      const float away = 0.5F * table.size_m.z() + kFromEdge_m;
      table.chairs.push_back(table.at *
                             Translation3f(along * 0.9F * table.size_m.x(), 0, -side * away) *
                             Eigen::AngleAxisf(side > 0 ? 0.0F : 3.14159265F, Vector3f::UnitY()));
    }
  }
  for (const Affine3f& chair : table.chairs)
    add_shell_chair(room, chair, palette.cloth, palette.metal);
  return table;
}

Person talker_on(Room& room, const Affine3f& chair, const Vector3f& looks_at_m, Random& random) {
  Person person = draw_person(room, random);
  const Seat seat = seat_of_chair(chair, kChairHeight_m);
  Waypoint stop;
  stop.at_m = seat.stand_m;
  stop.heading_rad = seat.heading_rad;
  stop.seat_m = seat.seat_m;
  stop.target_m = looks_at_m;
  stop.activity = Activity::kSitTalk;
  stop.stay_s = 30.0F;
  person.stops = {stop};
  person.begin_s = random.between(0.0F, 9.0F);
  return person;
}

}  // namespace

std::optional<Room> try_meeting(std::uint32_t seed) {
  Random random(seed);
  Room room = empty_room({random.between(5.8F, 6.4F), 2.7F, random.between(4.8F, 5.4F)},
                         {0.44F, 0.44F, 0.44F}, draw_sensor_mounts_around, random);
  FloorPlan plan = plan_of(room, random);

  add_plain_shell(room, random.chance(0.6F) ? FloorKind::kCarpet : FloorKind::kBoards, random);
  Furnisher furnisher(room, plan, random);
  furnisher.panels();
  // The board is on a long wall; the table is closer to the opposite wall.
  const bool flipped = random.chance(0.5F);
  const int board_wall = flipped ? 3 : 2;
  const float to_board = flipped ? 1.0F : -1.0F;
  const Vector2f middle(random.between(-0.25F, 0.25F), -to_board * random.between(0.25F, 0.4F));
  const auto table = add_meeting_table(room, plan, furnisher.palette(), middle,
                                       random.between(-0.05F, 0.05F), random);
  const auto board = plan.on_wall_at({1.9F, 1.3F, 0.09F}, 1.50F, board_wall);
  if (!table || !board) return std::nullopt;
  add_whiteboard(room, *board, furnisher.palette().metal, {1.8F, 1.1F}, random.seed());

  // Path along the board, from writing to showing, and back.
  const float lane = to_board * (0.5F * room.size_m.z() - 0.58F);
  const float along = board->translation().x();
  Waypoint write, show, think;
  write.target_m = {along + 0.25F * to_board, 1.35F, to_board * (0.5F * room.size_m.z() - 0.035F)};
  write.at_m = {along + 0.10F * to_board, lane};
  write.heading_rad = flipped ? 0.0F : 3.14159265F;
  write.activity = Activity::kWrite;
  write.stay_s = 6.0F;
  show.at_m = {along - 0.75F * to_board, lane};
  show.heading_rad = flipped ? 3.14159265F : 0.0F;
  show.activity = Activity::kTalk;
  show.stay_s = 6.0F;
  show.target_m = {middle.x(), 1.2F, middle.y()};
  const float side = along > 0 ? -1.0F : 1.0F;
  think.at_m = {along + side * 1.5F, lane - 0.1F * to_board};
  think.heading_rad = show.heading_rad;
  think.stay_s = 2.5F;
  think.target_m = show.target_m;
  plan.keep_way({std::min(show.at_m.x(), think.at_m.x()) - 0.3F, lane},
                {std::max(show.at_m.x(), think.at_m.x()) + 0.3F, lane}, 0.36F);
  if (std::abs(think.at_m.x()) > 0.5F * room.size_m.x() - 0.5F ||
      std::abs(show.at_m.x()) > 0.5F * room.size_m.x() - 0.5F)
    return std::nullopt;
  Person speaker = draw_person(room, random);
  speaker.stops = {write, show, think};
  speaker.pace_m_s = 0.8F;
  room.people.push_back(speaker);

  const auto chair = static_cast<std::size_t>(random.below(static_cast<int>(table->chairs.size())));
  room.people.push_back(talker_on(room, table->chairs[chair], {along, 1.5F, lane}, random));
  const Affine3f top = table->at * Translation3f(0, 0.74F, 0);
  add_laptop(room, top * Translation3f(-0.30F * table->size_m.x(), 0, 0.22F), random.seed());
  furnisher.set_out(top * Translation3f(0.1F * table->size_m.x(), 0, 0),
                    {0.5F * table->size_m.x(), 0.5F * table->size_m.z()}, 4);
  furnisher.wall_screen();
  furnisher.window();
  furnisher.door();
  furnisher.sideboard();
  furnisher.cabinet();
  furnisher.plant();
  furnisher.plant();
  furnisher.pictures(3 + random.below(3));
  furnisher.clock();
  furnisher.odds_and_ends(2);
  room.footprints = plan.taken();
  return room;
}

}  // namespace roomcast::simulator
