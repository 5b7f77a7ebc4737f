// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/scene/empty_room.h"
#include "roomcast/simulator/scene/furnisher.h"
#include "roomcast/simulator/scene/routes.h"
#include "roomcast/simulator/scene/scenes.h"

namespace roomcast::simulator {
namespace {

using Eigen::Vector2f;

/// Adds tripods below the first sensors, with space for the cables.
void set_up_tripods(Room& room, FloorPlan& plan, SurfaceIndex metal) {
  constexpr float kBelowEye_m = 0.16F;
  for (int i = 0; i < kTripods; ++i) {
    const SensorMount& mount = room.sensor_mounts[static_cast<std::size_t>(i)];
    const auto at = standing_at(mount.eye_m.x(), mount.eye_m.z(), 0.7F * static_cast<float>(i));
    const float height_m = mount.eye_m.y() - kBelowEye_m;
    plan.take(at, {0.62F, height_m, 0.62F});
    add_tripod(room, at, metal, height_m);
  }
}

Waypoint doing(Activity activity, const Vector2f& at_m, float heading_rad, float stay_s) {
  Waypoint stop;
  stop.at_m = at_m;
  stop.heading_rad = heading_rad;
  stop.activity = activity;
  stop.stay_s = stay_s;
  return stop;
}

/// Shows exercises to the first sensor, walks up and down, stretches slowly, pauses.
Person demonstrator(Room& room, float x, Random& random) {
  const float back_m = random.between(-0.5F, -0.4F), front_m = random.between(0.25F, 0.35F);
  const auto askew = [&] { return random.between(-0.25F, 0.25F); };
  Person person = draw_person(room, random);
  person.stops = {
      doing(Activity::kExercise, {x, front_m}, askew(), random.between(5.0F, 6.0F)),
      doing(Activity::kStand, {x, back_m}, askew(), 0.8F),
      doing(Activity::kExercise, {x, front_m - 0.1F}, askew(), random.between(4.0F, 5.0F)),
      doing(Activity::kStretch, {x, back_m}, askew(), random.between(5.0F, 6.0F))};
  person.pace_m_s = random.between(0.85F, 1.0F);
  return person;
}

}  // namespace

std::optional<Room> try_studio(std::uint32_t seed) {
  Random random(seed);
  Room room = empty_room({random.between(5.8F, 6.4F), 2.8F, random.between(5.0F, 5.4F)},
                         {0.46F, 0.46F, 0.46F}, draw_sensor_mounts_on_tripods, random);
  FloorPlan plan(room.size_m, random.seed());
  add_plain_shell(room, FloorKind::kBoards, random);
  Furnisher furnisher(room, plan, random);
  set_up_tripods(room, plan, furnisher.palette().dark);
  for (const SensorMount& mount : room.sensor_mounts) plan.keep_view(mount);
  plan.keep_way({-0.5F, 0.0F}, {0.5F, 0.0F}, 1.2F);

  furnisher.panels();
  furnisher.door();
  room.people.push_back(demonstrator(room, random.between(0.55F, 0.65F), random));
  room.people.push_back(demonstrator(room, random.between(-0.65F, -0.55F), random));
  room.people.back().begin_s = random.between(1.5F, 2.5F);
  furnisher.wall_screen();
  furnisher.whiteboard(0.0F);
  furnisher.window();
  furnisher.window();
  furnisher.sideboard();
  furnisher.bookshelf();
  furnisher.cabinet();
  furnisher.plant();
  furnisher.plant();
  furnisher.pictures(4 + random.below(4));
  furnisher.clock();
  furnisher.odds_and_ends(4 + random.below(3));
  furnisher.rug_under(Vector2f::Zero(), {random.between(2.4F, 2.8F), random.between(1.6F, 1.9F)});
  room.footprints = plan.taken();
  return room;
}

}  // namespace roomcast::simulator
