// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/upstream/mirrored_room.h"

#include <vector>

#include <gtest/gtest.h>

#include "roomcast/hub/federation/mirror/room_here_fixture.h"

namespace roomcast::hub::federation {
namespace {

namespace wpb = wire::pb;
using namespace std::chrono_literals;
using hub::federation::person;
using hub::federation::pose_of;
using hub::federation::RoomHere;
using hub::federation::sensor_there;

wpb::Roster roster_of(std::initializer_list<wpb::SensorEntry> sensors) {
  wpb::Roster roster;
  for (const auto& sensor : sensors) *roster.add_sensors() = sensor;
  return roster;
}

class MirroredRoomTest : public testing::Test {
 protected:
  /// The room here sends a welcome to the `n`th client that joined, as sensor `id`.
  void welcome(std::size_t n, std::uint32_t id = 0) {
    wpb::Control control;
    control.mutable_welcome()->set_sensor_id(id);
    EXPECT_FALSE(mirrored.on_room_message(here.joins.at(n).first, control).has_value());
  }

  RoomHere here;
  MirroredRoom mirrored{"lab", "own", here, unread_connections()};
};

TEST_F(MirroredRoomTest, sensors_there_join_here_with_an_aligner) {
  mirrored.on_roster(roster_of({sensor_there(7, "left")}));
  ASSERT_EQ(here.joins.size(), 2u);
  EXPECT_TRUE(here.joins[0].second.has_aligner());
  const wpb::Join& join = here.joins[1].second;
  EXPECT_EQ(join.room(), "lab");
  EXPECT_EQ(join.token(), "own");
  EXPECT_EQ(join.name(), "left");
  EXPECT_EQ(join.sensor().fps(), 30);
  EXPECT_EQ(join.sensor().world_from_depth_size(), 16) << "its pose was given";
}

TEST_F(MirroredRoomTest, estimated_poses_are_sent_as_placements) {
  mirrored.on_roster(roster_of({sensor_there(7, "left", wpb::PLACEMENT_ALIGNED)}));
  EXPECT_EQ(here.joins.at(1).second.sensor().world_from_depth_size(), 0);
  welcome(0);
  EXPECT_TRUE(here.controls.empty()) << "its id here is not known yet";
  welcome(1, 3);
  ASSERT_EQ(here.controls.size(), 1u);
  EXPECT_EQ(here.controls[0].first, here.joins[0].first);
  const auto& placement = here.controls[0].second.placements().sensors(0);
  EXPECT_EQ(placement.sensor_id(), 3u);
  EXPECT_EQ(placement.world_from_depth_size(), 16);
}

TEST_F(MirroredRoomTest, a_sensor_that_leaves_there_leaves_here_and_a_changed_one_rejoins) {
  mirrored.on_roster(roster_of({sensor_there(7, "left"), sensor_there(8, "right")}));
  auto offline = sensor_there(7, "left");
  offline.set_online(false);
  auto faster = sensor_there(8, "right");
  faster.set_fps(60);
  mirrored.on_roster(roster_of({offline, faster}));
  EXPECT_EQ(here.left.size(), 2u);
  ASSERT_EQ(here.joins.size(), 4u);
  EXPECT_EQ(here.joins[3].second.sensor().fps(), 60);
}

TEST_F(MirroredRoomTest, all_clients_leave_when_the_other_hub_is_gone) {
  mirrored.on_roster(roster_of({sensor_there(7, "left")}));
  mirrored.on_hub_lost();
  EXPECT_EQ(here.left.size(), 2u);
  mirrored.on_roster(roster_of({sensor_there(7, "left")}));
  EXPECT_EQ(here.joins.size(), 4u) << "and rejoins with it";
}

TEST_F(MirroredRoomTest, a_removed_sensor_rejoins_with_the_next_roster) {
  mirrored.on_roster(roster_of({sensor_there(7, "left")}));
  mirrored.on_removed(here.joins[1].first);
  mirrored.on_roster(roster_of({sensor_there(7, "left")}));
  EXPECT_EQ(here.joins.size(), 3u);
  EXPECT_TRUE(here.left.empty()) << "the room knows already";
}

TEST_F(MirroredRoomTest, shows_people_there_except_us_and_people_behind_us) {
  EXPECT_EQ(mirrored.on_welcome(4).size(), 2u);
  wpb::Roster roster;
  *roster.add_viewers() = person(3, "Ada");
  *roster.add_viewers() = person(4, "hub");
  *roster.add_viewers() = person(5, "behind us", 1, 4);
  *roster.add_viewers() = person(6, "behind another", 1, 8);
  mirrored.on_roster(roster);
  EXPECT_TRUE(here.controls.empty()) << "no sensor is welcome yet";
  welcome(0);
  ASSERT_EQ(here.controls.size(), 1u);
  EXPECT_EQ(here.controls[0].first, here.joins[0].first);
  const auto& people = here.controls[0].second.people_here();
  ASSERT_EQ(people.people_size(), 2);
  EXPECT_EQ(people.people(0).name(), "Ada");
  EXPECT_EQ(people.people(1).name(), "behind another");
  mirrored.on_roster(roster);
  EXPECT_EQ(here.controls.size(), 1u) << "nothing changed";
  mirrored.on_poses(pose_of(3).viewer_poses());
  EXPECT_TRUE(here.controls.back().second.has_viewer_poses());
}

TEST_F(MirroredRoomTest, reports_people_here_except_those_from_there) {
  mirrored.on_roster({});
  welcome(0);
  wpb::Control control;
  *control.mutable_roster()->add_viewers() = person(1, "Bob");
  *control.mutable_roster()->add_viewers() = person(2, "from there", 1);
  *control.mutable_roster()->add_viewers() = person(3, "behind a hub here", 1, 9);
  const auto aligner = here.joins[0].first;
  const auto report = mirrored.on_room_message(aligner, control);
  ASSERT_TRUE(report);
  ASSERT_EQ(report->people_here().people_size(), 2);
  EXPECT_EQ(report->people_here().people(0).name(), "Bob");
  EXPECT_EQ(report->people_here().people(1).name(), "behind a hub here");
  EXPECT_FALSE(mirrored.on_room_message(aligner, control)) << "nothing changed";
  EXPECT_TRUE(mirrored.on_room_message(aligner, pose_of(1)));
  EXPECT_FALSE(mirrored.on_room_message(aligner, pose_of(2)));
  const auto first = mirrored.on_welcome(4);  // the connection is new
  EXPECT_EQ(first[0].people_here().people_size(), 2);
  EXPECT_EQ(first[1].viewer_poses().poses_size(), 1);
}

}  // namespace
}  // namespace roomcast::hub::federation
