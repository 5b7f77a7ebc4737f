// SPDX-License-Identifier: Apache-2.0
#include "roomcast/aligner/room_placing.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "roomcast/align/made_up_room.h"
#include "roomcast/aligner/made_up_walk.h"

namespace roomcast::aligner {
namespace {

TEST(RoomPlacing, a_view_of_no_use_is_reported) {
  auto dark = align::made_up_bundle({}, "dark", align::corner_pose(2, 1.5));
  dark.color = ColorImage(dark.color.width(), dark.color.height());
  RoomPlacing placing;
  placing.add(dark);
  const auto placements = placing.solve({}, {});
  ASSERT_EQ(placements.size(), 1U);
  EXPECT_EQ(placements[0].sensor, "dark");
  EXPECT_FALSE(placements[0].note.empty());
}

/// A long grey corridor, lit from one side: nothing that is seen there tells how far along it
/// somebody stands.
align::CalibrationBundle in_corridor(const std::string& name,
                                     const RigidTransform& world_from_depth) {
  align::MadeUpRoom corridor;
  corridor.walls = {Eigen::Vector3d(-30, 0, -2), Eigen::Vector3d(30, 2.6, 1.8)};
  corridor.boxes.clear();
  return align::without_pattern(align::made_up_bundle(corridor, name, world_from_depth));
}

TEST(RoomPlacing, a_walk_tells_where_a_sensor_stands_and_what_both_see_how_exactly) {
  const RigidTransform first = world_from_optical_looking_at({-1, 1.7, -1.6}, {-0.3, 0.6, 1});
  const RigidTransform second = world_from_optical_looking_at({1, 1.7, -1.6}, {0.3, 0.6, 1});
  RoomPlacing placing;
  placing.add(in_corridor("first", first));
  placing.add(in_corridor("second", second));
  const auto placed_second = [&] {
    const auto placements = placing.solve({{"first", first}}, {});
    return *std::ranges::find(placements, "second", &Placement::sensor);
  };
  ASSERT_FALSE(placed_second().world_from_depth) << "it could be anywhere along the corridor";
  ASSERT_TRUE(placing.wants_sightings());

  // Its crown is seen unlike from both sides: that puts the walk off by half of the difference.
  placing.see("first", stroll_seen_from(first, 0.11));
  placing.see("second", stroll_seen_from(second, 0.03));
  const Placement found = placed_second();
  ASSERT_TRUE(found.world_from_depth) << found.note;
  const Eigen::Vector3d off = found.world_from_depth->translation_m - second.translation_m;
  EXPECT_NEAR(off.z(), 0, 0.01) << "the wall tells";
  EXPECT_NEAR(off.x(), 0, 0.06) << "the walk tells";
}

}  // namespace
}  // namespace roomcast::aligner
