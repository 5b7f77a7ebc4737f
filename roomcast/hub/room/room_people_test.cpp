// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "roomcast/hub/room/room_test_fixture.h"

namespace roomcast::hub {
namespace {

pb::Join hub_join() {
  pb::Join join = viewer_join("hub");
  join.mutable_viewer()->set_relays(true);
  return join;
}

pb::Control people(std::initializer_list<std::uint32_t> ids) {
  pb::Control control;
  control.mutable_people_here();
  for (const auto id : ids) control.mutable_people_here()->add_people()->set_id(id);
  return control;
}

pb::Control pose_of(std::uint32_t id, float x) {
  pb::Control control;
  auto& pose = *control.mutable_viewer_poses()->add_poses();
  pose.set_viewer_id(id);
  pose.mutable_head()->set_x(x);
  return control;
}

TEST_F(RoomTest, people_behind_a_hub_are_shown_until_it_leaves) {
  const auto viewer = enter(viewer_join("Ada"));  // viewer 1
  const auto hub = enter(hub_join());             // viewer 2
  auto told = room.control(hub, people({9}), at(1s));
  const auto roster = newest_roster(told);
  ASSERT_EQ(roster.viewers_size(), 3);
  EXPECT_EQ(roster.viewers(2).through(), 2u);
  const std::uint32_t id = roster.viewers(2).id();

  EXPECT_TRUE(room.control(hub, pose_of(9, 3), at(2s)).empty());
  const auto poses = messages(room.tick(at(2s)), pb::Control::kViewerPoses);
  ASSERT_EQ(poses.size(), 1u);
  EXPECT_EQ(poses[0].message.viewer_poses().poses(0).viewer_id(), id);
  EXPECT_EQ(poses[0].message.viewer_poses().poses(0).head().x(), 3);

  EXPECT_EQ(newest_roster(room.leave(hub, at(3s))).viewers_size(), 1);
  (void)viewer;
}

TEST_F(RoomTest, an_empty_room_needs_no_tick) {
  const auto viewer = enter(viewer_join("Ada"));
  (void)room.leave(viewer, at(1ms));
  int ticks = 0;  // for the roster, and for the end of the demand for frames
  for (; room.next_tick() && ticks < 10; ++ticks) (void)room.tick(*room.next_tick());
  EXPECT_LT(ticks, 4);
}

TEST_F(RoomTest, only_a_hub_may_report_people) {
  for (const auto& message : {people({9}), pose_of(9, 3)}) {
    const auto viewer = enter(viewer_join("Ada"));
    const auto refused = all<Disconnect>(room.control(viewer, message, at(1s)));
    ASSERT_EQ(refused.size(), 1u);
    EXPECT_EQ(refused[0].code, pb::ERROR_UNEXPECTED);
  }
}

TEST_F(RoomTest, a_hub_sets_poses_of_its_own_people_only) {
  const auto viewer = enter(viewer_join("Ada"));  // viewer 1
  const auto hub = enter(hub_join());
  const auto other = enter(hub_join());
  (void)room.control(other, people({9}), at(1s));
  for (const std::uint32_t id : {1u, 9u, 4u}) {
    EXPECT_TRUE(room.control(hub, pose_of(id, 3), at(2s)).empty());
  }
  EXPECT_TRUE(messages(room.tick(at(3s)), pb::Control::kViewerPoses).empty());
  (void)viewer;
}

TEST_F(RoomTest, a_hub_that_reports_people_too_often_is_disconnected) {
  const auto hub = enter(hub_join());
  std::vector<Disconnect> refused;
  for (std::uint32_t i = 0; i < 1000 && refused.empty(); ++i) {
    refused = all<Disconnect>(room.control(hub, people({i}), at(1s)));
  }
  ASSERT_EQ(refused.size(), 1u);
  EXPECT_EQ(refused[0].code, pb::ERROR_TOO_FAST);
}

TEST_F(RoomTest, the_backplane_gets_poses_and_reports_remote_people) {
  const auto viewer = enter(viewer_join("Ada"));
  pb::Control pose;
  pose.mutable_viewer_pose()->mutable_head()->set_x(1);
  (void)room.control(viewer, pose, at(1s));
  (void)room.tick(at(1s));
  const auto backplane = enter(aligner_join(), 2s, {.is_backplane = true});
  auto poses = messages(room.tick(at(2s)), pb::Control::kViewerPoses);
  ASSERT_EQ(poses.size(), 1u) << "it has just come and knows of nobody";
  EXPECT_THAT(poses[0].to, testing::Contains(backplane));
  const auto roster = newest_roster(room.control(backplane, people({9}), at(3s)));
  ASSERT_EQ(roster.viewers_size(), 2);
  EXPECT_EQ(roster.viewers(1).hubs_away(), 1u);
  EXPECT_EQ(roster.viewers(1).through(), 0u);
  EXPECT_EQ(newest_roster(room.leave(backplane, at(4s))).viewers_size(), 1);
}

}  // namespace
}  // namespace roomcast::hub
