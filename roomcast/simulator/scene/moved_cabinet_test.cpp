// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/scene/moved_cabinet.h"

#include <gtest/gtest.h>

namespace roomcast::simulator {
namespace {

TEST(MovedCabinet, stands_in_two_places_that_are_apart_and_within_the_room) {
  Room room = build_room("livingroom", 41).value();
  const auto places = cabinet_places(room);
  ASSERT_TRUE(places);
  EXPECT_FALSE((*places)[0].intersects((*places)[1]));
  const Eigen::Vector3f half_m = 0.5F * room.size_m;
  const Eigen::AlignedBox3f inside(Eigen::Vector3f(-half_m.x(), 0, -half_m.z()),
                                   Eigen::Vector3f(half_m.x(), room.size_m.y(), half_m.z()));
  for (const int place : {0, 1}) {
    EXPECT_TRUE(inside.contains(places->at(std::size_t(place))));
    Room furnished = room;
    ASSERT_TRUE(add_cabinet(furnished, place));
    EXPECT_EQ(furnished.footprints.size(), room.footprints.size() + 1);
    const auto& points_m = furnished.mesh.positions;
    for (std::size_t i = room.mesh.positions.size(); i < points_m.size(); ++i)
      EXPECT_LT(places->at(std::size_t(place)).exteriorDistance(points_m[i]), 0.05F);
    EXPECT_GT(points_m.size(), room.mesh.positions.size());
  }
}

TEST(MovedCabinet, a_room_without_space_stays_as_it_is) {
  Room room = build_room("livingroom", 41).value();
  room.size_m = {1, 2.6F, 1};
  const std::size_t points = room.mesh.positions.size();
  EXPECT_FALSE(add_cabinet(room, 0));
  EXPECT_EQ(room.mesh.positions.size(), points);
}

}  // namespace
}  // namespace roomcast::simulator
