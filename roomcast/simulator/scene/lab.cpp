// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/scene/empty_room.h"
#include "roomcast/simulator/scene/furnisher.h"
#include "roomcast/simulator/scene/routes.h"
#include "roomcast/simulator/scene/scenes.h"

namespace roomcast::simulator {
namespace {

using Eigen::Affine3f;
using Eigen::Vector3f;

/// A monitor on its foot, with its centre at the origin.
Burden monitor_to_carry(Room& room, const Palette& palette, Random& random) {
  Surface shown =
      glazed(painted(Pattern::kScreen, 0x20262e, 0x3a6a9a, 0x101418, random.seed(), 0.05F));
  shown.size_m = {0.52F, 0.31F};
  Burden burden;
  burden.half_size_m = {0.272F, 0.226F, 0.09F};
  burden.mesh = built_apart(room, [&] {
    const Affine3f at(Eigen::Translation3f(0, -burden.half_size_m.y(), 0));
    add_monitor(room, at, palette.dark, shown);
  });
  return burden;
}

void wear_coat(Person& person, Room& room, Random& random) {
  person.build.hem_m = 0.36F;
  person.build.sleeve = 0.92F;
  person.outfit.shirt =
      room.add(painted(Pattern::kFabric, 0xe8e8e4, 0xd4d6d6, 0, random.seed(), 0.65F));
}

}  // namespace

std::optional<Room> try_lab(std::uint32_t seed) {
  Random random(seed);
  Room room = empty_room({random.between(5.8F, 6.6F), 2.9F, random.between(4.8F, 5.4F)},
                         {0.44F, 0.45F, 0.46F}, draw_sensor_mounts_around, random);
  FloorPlan plan = plan_of(room, random);

  add_plain_shell(room, random.chance(0.5F) ? FloorKind::kConcrete : FloorKind::kTerrazzo, random);
  Furnisher furnisher(room, plan, random);
  furnisher.panels();
  furnisher.door();
  Route route(room, plan, random);
  const auto bench = furnisher.lab_bench(0.8F, false);
  const auto store = furnisher.lab_bench(0.8F, false);
  const auto rack = furnisher.rack();
  if (!bench || !store || !rack) return std::nullopt;
  const Vector3f rest(random.between(-0.35F, -0.15F), 0.90F + 0.226F, 0.14F);
  const Vector3f socket(rest.x() + 0.05F, 0.97F, 0.02F);
  if (!route.to_reach(*store, rest, Activity::kTakeUp, 3.2F) ||
      !route.to_reach(*bench, rest, Activity::kPutDown, 3.2F) ||
      !route.to_reach(*bench, socket, Activity::kPlug, 4.5F) ||
      !route.to_reach(*rack, {0.05F, random.between(0.4F, 0.6F), 0.42F}, Activity::kPlug, 5.0F) ||
      !route.to_reach(*bench, rest, Activity::kTakeUp, 3.2F) ||
      !route.to_reach(*store, rest, Activity::kPutDown, 3.2F))
    return std::nullopt;
  Person carrier = route.walker();
  carrier.burden = monitor_to_carry(room, furnisher.palette(), random);
  if (random.chance(0.5F)) wear_coat(carrier, room, random);
  room.people.push_back(carrier);

  const auto desk = furnisher.desk(true);
  if (desk) {
    Person typist = draw_person(room, random);
    typist.stops = {typing_at(*desk)};
    room.people.push_back(typist);
  } else if (auto other = route.bystander()) {
    wear_coat(*other, room, random);
    room.people.push_back(*std::move(other));
  }
  furnisher.lab_bench(0.3F, true);
  furnisher.lab_bench(0.0F, true);
  furnisher.rack();
  furnisher.cabinet();
  furnisher.bookshelf();
  furnisher.desk(false);
  furnisher.whiteboard(0.0F);
  furnisher.window();
  furnisher.pictures(4 + random.below(4));
  furnisher.clock();
  furnisher.odds_and_ends(4 + random.below(3));
  const float y = room.size_m.y() - 0.35F, x = 0.5F * room.size_m.x() - 0.02F;
  const float z =
      random.between(0.15F, 0.3F) * room.size_m.z() * (random.chance(0.5F) ? 1.0F : -1.0F);
  add_cable_tray(room, {-x, y, z}, {x, y, z}, furnisher.palette().metal, random.seed());
  room.footprints = plan.taken();
  return room;
}

}  // namespace roomcast::simulator
