// SPDX-License-Identifier: Apache-2.0
// An open plan: sensors around a few desks in the middle of a hall whose walls are farther away
// than the sensors reach. There is floor, furniture, and nothing behind.
#include "roomcast/simulator/scene/empty_room.h"
#include "roomcast/simulator/scene/furnisher.h"
#include "roomcast/simulator/scene/routes.h"
#include "roomcast/simulator/scene/scenes.h"

namespace roomcast::simulator {
namespace {

using Eigen::Affine3f;
using Eigen::Vector3f;

const Vector3f kZone_m(6.2F, 2.6F, 5.0F);  // around which the sensors stand

Stands stands_around_the_zone(const Vector3f&, Random& random) {
  return draw_sensor_mounts_around(kZone_m, random);
}

/// A place in the zone or, for the rest of the hall, anywhere.
std::optional<Affine3f> place_in_zone(FloorPlan& plan, Random& random, const Vector3f& size_m) {
  for (int i = 0; i < 60; ++i) {
    const Affine3f at =
        standing_at(random.between(-0.4F, 0.4F) * kZone_m.x(),
                    random.between(-0.4F, 0.4F) * kZone_m.z(), random.between(0.0F, 6.28F));
    if (plan.take(at, size_m)) return at;
  }
  return std::nullopt;
}

void add_desk_with_laptop(Room& room, const Furnisher& furnisher, const Affine3f& at,
                          Random& random) {
  add_table(room, at, furnisher.palette().wood, {1.4F, 0.73F, 0.7F});
  add_laptop(room, moved(at, {random.between(-0.3F, 0.3F), 0.73F, 0}), random.seed());
  add_book_stack(room, moved(at, {0.5F, 0.73F, 0.1F}), 1 + random.below(3), random.seed());
}

}  // namespace

std::optional<Room> try_open_plan(std::uint32_t seed) {
  Random random(seed);
  Room room = empty_room({random.between(15.0F, 17.0F), 3.4F, random.between(13.0F, 15.0F)},
                         {0.55F, 0.55F, 0.55F}, stands_around_the_zone, random);
  FloorPlan plan = plan_of(room, random);
  add_plain_shell(room, random.chance(0.5F) ? FloorKind::kCarpet : FloorKind::kConcrete, random);
  Furnisher furnisher(room, plan, random);
  furnisher.panels();
  Person walker = draw_person(room, random);
  walker.stops = {Waypoint{}, Waypoint{}};
  walker.stops[0].at_m = {-1.2F, 0};
  walker.stops[1].at_m = {1.2F, 0.2F};
  room.people.push_back(walker);
  plan.keep_way(walker.stops[0].at_m, walker.stops[1].at_m, 0.5F);
  for (int i = 3 + random.below(2); i > 0; --i) {
    if (const auto at = place_in_zone(plan, random, {1.4F, 1.0F, 0.75F}))
      add_desk_with_laptop(room, furnisher, *at, random);
  }
  for (int i = 4 + random.below(3); i > 0; --i) {
    if (const auto at = place_in_zone(plan, random, {0.65F, 1.0F, 0.65F}))
      add_office_chair(room, *at, furnisher.palette().cloth, furnisher.palette().dark);
  }
  for (int i = 10; i > 0; --i) {
    if (const auto at = plan.in_the_open({1.4F, 1.0F, 0.75F}))
      add_desk_with_laptop(room, furnisher, *at, random);
  }
  furnisher.odds_and_ends(6);
  furnisher.pictures(6);
  furnisher.window();
  room.footprints = plan.taken();
  return room;
}

}  // namespace roomcast::simulator
