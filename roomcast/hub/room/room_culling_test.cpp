// SPDX-License-Identifier: Apache-2.0
// Which frames a Room leaves out for which viewer.
#include "roomcast/hub/room/room_test_fixture.h"

namespace roomcast::hub {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// The sensors of the fixture look along +z from (1, 0, 0).
pb::Control sees_a_wall() {
  pb::Control control;
  auto& depth = *control.mutable_coarse_depth();
  depth.set_columns(1);
  depth.set_rows(1);
  depth.add_near_cm(200);
  depth.add_far_cm(200);
  return control;
}

pb::Join sensor_with_lens(const std::string& name,
                          std::optional<RigidTransform> world_from_depth = pose_at(1)) {
  pb::Join join = sensor_join(name, world_from_depth);
  auto& depth = *join.mutable_sensor()->mutable_calibration()->mutable_depth();
  depth.set_height(424);
  depth.set_fx(365);
  depth.set_fy(365);
  depth.set_cx(255.5);
  depth.set_cy(211.5);
  return join;
}

/// At (1, 0, 0), with the sensor's view ahead or behind.
pb::Control looks_at_the_wall(bool does) {
  pb::Control control;
  auto& pose = *control.mutable_viewer_pose();
  pose.mutable_head()->set_x(1);
  if (does) {
    pose.mutable_head()->set_qy(1);  // half a turn: towards +z
  } else {
    pose.mutable_head()->set_qw(1);
  }
  pose.set_view_half_angle(0.7F);
  return control;
}

/// All actions until `end`.
RoomActions run_room(Room& room, nanoseconds end) {
  RoomActions out;
  while (room.next_tick() && *room.next_tick() <= at(end)) {
    const RoomTime next = *room.next_tick();
    std::ranges::move(room.tick(next), std::back_inserter(out));
  }
  return out;
}

std::vector<SendControl> unseen(const RoomActions& actions) {
  return messages(actions, pb::Control::kUnseenSensors);
}

TEST_F(RoomTest, a_viewer_who_looks_elsewhere_is_told_and_gets_no_frames) {
  const auto sensor = enter(sensor_with_lens("left"));
  const auto viewer = enter(viewer_join());
  (void)room.control(sensor, sees_a_wall(), at(1s));
  (void)room.control(viewer, looks_at_the_wall(false), at(1s));
  actions = run_room(room, 10s);
  const auto details = all<SetDetails>(actions);
  ASSERT_EQ(details.size(), 2U);
  EXPECT_EQ(details[0].viewer, viewer);
  EXPECT_THAT(details[0].details, ElementsAre(Detail::kBaseOnly));
  EXPECT_THAT(details[1].details, ElementsAre(Detail::kPaused));
  ASSERT_EQ(unseen(actions).size(), 2U);
  EXPECT_THAT(unseen(actions)[0].to, ElementsAre(viewer));
  EXPECT_THAT(unseen(actions)[0].message.unseen_sensors().base_only(), ElementsAre(0));
  EXPECT_THAT(unseen(actions)[1].message.unseen_sensors().paused(), ElementsAre(0));
}

TEST_F(RoomTest, a_viewer_is_told_of_sensors_that_his_line_holds_back_beside_unseen_ones) {
  const auto sensor = enter(sensor_with_lens("left"));
  enter(sensor_with_lens("right"));
  const auto viewer = enter(viewer_join());
  const SensorId left{0}, right{1};
  auto told =
      unseen(room.small_needed(viewer, {.wanted = {left, right}, .held_back = {right}}, at(1s)));
  ASSERT_EQ(told.size(), 1U);
  EXPECT_THAT(told[0].to, ElementsAre(viewer));
  EXPECT_THAT(told[0].message.unseen_sensors().held_back(), ElementsAre(1));
  EXPECT_THAT(told[0].message.unseen_sensors().base_only(), ElementsAre(1))
      << "for earlier viewers";
  EXPECT_THAT(unseen(room.small_needed(viewer, {.wanted = {left}, .held_back = {right}}, at(1s))),
              IsEmpty())
      << "no news";

  (void)room.control(sensor, sees_a_wall(), at(2s));
  (void)room.control(viewer, looks_at_the_wall(false), at(2s));
  actions = run_room(room, 12s);
  told = unseen(actions);
  ASSERT_EQ(told.size(), 2U);
  EXPECT_THAT(told[0].message.unseen_sensors().base_only(), ElementsAre(0, 1));
  EXPECT_THAT(told[1].message.unseen_sensors().paused(), ElementsAre(0));
  EXPECT_THAT(told[1].message.unseen_sensors().held_back(), ElementsAre(1)) << "it stays so";
  told = unseen(room.small_needed(viewer, {.held_back = {left}}, at(13s)));
  ASSERT_EQ(told.size(), 1U);
  EXPECT_THAT(told[0].message.unseen_sensors().paused(), ElementsAre(0));
  EXPECT_THAT(told[0].message.unseen_sensors().held_back(), IsEmpty()) << "nothing comes of it";
}

TEST_F(RoomTest, a_viewer_who_turns_round_gets_a_key_frame) {
  const auto sensor = enter(sensor_with_lens("left"));
  const auto viewer = enter(viewer_join());
  (void)room.control(sensor, sees_a_wall(), at(1s));
  (void)room.control(viewer, looks_at_the_wall(false), at(1s));
  (void)run_room(room, 10s);
  (void)room.control(viewer, looks_at_the_wall(true), at(10s));
  actions = run_room(room, 10s + 10ms);
  ASSERT_EQ(all<SetDetails>(actions).size(), 1U);
  EXPECT_THAT(all<SetDetails>(actions)[0].details, IsEmpty()) << "everything";
  const auto keys = messages(actions, pb::Control::kKeyRequest);
  ASSERT_EQ(keys.size(), 1U);
  EXPECT_THAT(keys[0].to, ElementsAre(sensor));
}

TEST_F(RoomTest, a_sensor_that_nobody_sees_is_told_so_until_somebody_turns_to_it) {
  const auto sensor = enter(sensor_with_lens("left"));
  const auto viewer = enter(viewer_join());
  (void)room.control(sensor, sees_a_wall(), at(1s));
  (void)room.control(viewer, looks_at_the_wall(false), at(1s));
  const auto told = messages(run_room(room, 10s), pb::Control::kFrameDemand);
  ASSERT_EQ(told.size(), 2U);
  EXPECT_TRUE(told[0].message.frame_demand().base_only());
  EXPECT_FALSE(told[0].message.frame_demand().unseen());
  EXPECT_TRUE(told[1].message.frame_demand().unseen());
  EXPECT_TRUE(told[1].message.frame_demand().wanted()) << "earlier sensors go on";
  EXPECT_THAT(told[1].to, ElementsAre(sensor));
  EXPECT_TRUE(room.stats().sensors[0].is_unseen);

  (void)room.control(viewer, looks_at_the_wall(true), at(10s));
  const auto again = messages(run_room(room, 10s + 10ms), pb::Control::kFrameDemand);
  ASSERT_EQ(again.size(), 1U);
  EXPECT_FALSE(again[0].message.frame_demand().unseen());
  EXPECT_FALSE(again[0].message.frame_demand().base_only());
}

TEST_F(RoomTest, a_recorder_sees_everything) {
  const auto sensor = enter(sensor_with_lens("left"));
  const auto viewer = enter(viewer_join());
  (void)room.control(sensor, sees_a_wall(), at(1s));
  (void)room.control(viewer, looks_at_the_wall(false), at(1s));
  (void)run_room(room, 10s);
  const auto recorder = enter(viewer_join("recorder"), 10s);
  const auto told = messages(actions, pb::Control::kFrameDemand);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_FALSE(told[0].message.frame_demand().unseen());
  EXPECT_EQ(messages(room.leave(recorder, at(11s)), pb::Control::kFrameDemand).size(), 1U);
}

TEST_F(RoomTest, a_viewer_who_leaves_has_no_wishes_any_more) {
  const auto sensor = enter(sensor_with_lens("left"));
  const auto away = enter(viewer_join()), there = enter(viewer_join());
  (void)room.control(sensor, sees_a_wall(), at(1s));
  (void)room.control(away, looks_at_the_wall(false), at(1s));
  (void)room.control(there, looks_at_the_wall(true), at(1s));
  EXPECT_THAT(messages(run_room(room, 20s), pb::Control::kFrameDemand), IsEmpty());
  const auto told = messages(room.leave(there, at(20s)), pb::Control::kFrameDemand);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_TRUE(told[0].message.frame_demand().unseen());
}

TEST_F(RoomTest, a_sensor_that_is_moved_or_not_placed_comes_whole) {
  const auto given = enter(sensor_with_lens("given"));
  const auto unplaced = enter(sensor_with_lens("unplaced", std::nullopt));
  const auto viewer = enter(viewer_join());
  (void)room.control(given, sees_a_wall(), at(1s));
  (void)room.control(unplaced, sees_a_wall(), at(1s));
  (void)room.control(viewer, looks_at_the_wall(false), at(1s));
  for (const auto& change : all<SetDetails>(run_room(room, 10s)))
    EXPECT_EQ(detail_of(change.details, SensorId{1}), Detail::kAll);
  pb::Control moved;
  moved.mutable_sensor_moved();
  (void)room.control(given, moved, at(10s));
  const auto details = all<SetDetails>(run_room(room, 11s));
  ASSERT_EQ(details.size(), 1U);
  EXPECT_THAT(details[0].details, IsEmpty());
}

TEST_F(RoomTest, a_sensor_that_comes_back_has_told_nothing_yet) {
  const auto sensor = enter(sensor_with_lens("left"));
  const auto viewer = enter(viewer_join());
  (void)room.control(sensor, sees_a_wall(), at(1s));
  (void)room.control(viewer, looks_at_the_wall(false), at(1s));
  (void)run_room(room, 10s);
  (void)room.leave(sensor, at(10s));
  enter(sensor_with_lens("left"), 10s);
  const auto details = all<SetDetails>(run_room(room, 11s));
  ASSERT_FALSE(details.empty());
  EXPECT_THAT(details.back().details, IsEmpty());
}

TEST_F(RoomTest, an_angle_of_view_is_not_passed_on) {
  const auto viewer = enter(viewer_join());
  enter(viewer_join());
  (void)room.control(viewer, looks_at_the_wall(true), at(1s));
  const auto poses = messages(run_room(room, 2s), pb::Control::kViewerPoses);
  ASSERT_FALSE(poses.empty());
  EXPECT_EQ(poses[0].message.viewer_poses().poses(0).view_half_angle(), 0);
}

TEST_F(RoomTest, only_sensors_tell_of_depth) {
  const auto viewer = enter(viewer_join());
  EXPECT_EQ(all<Disconnect>(room.control(viewer, sees_a_wall(), at(1s))).size(), 1U);
}

pb::Join sensor_that_takes_views() {
  pb::Join join = sensor_with_lens("left");
  join.mutable_sensor()->set_takes_views(true);
  return join;
}

std::vector<SendControl> watched_from(const RoomActions& actions) {
  return messages(actions, pb::Control::kWatchedFrom);
}

TEST_F(RoomTest, a_sensor_that_takes_views_is_told_from_where_it_is_looked_at) {
  const auto sensor = enter(sensor_that_takes_views());
  (void)enter(sensor_with_lens("earlier"));
  const auto viewer = enter(viewer_join());
  EXPECT_THAT(watched_from(run_room(room, 1s)), IsEmpty()) << "nobody has told where he looks";
  (void)room.control(viewer, looks_at_the_wall(true), at(1s));
  const auto told = watched_from(run_room(room, 2s));
  ASSERT_EQ(told.size(), 1U);
  EXPECT_THAT(told[0].to, ElementsAre(sensor));
  ASSERT_EQ(told[0].message.watched_from().cones_size(), 1);
  const pb::ViewCone& cone = told[0].message.watched_from().cones(0);
  EXPECT_NEAR(cone.eye().x(), 0, 1e-5) << "where the sensor is";
  EXPECT_NEAR(cone.forward().z(), 1, 1e-5);
  EXPECT_GT(cone.half_angle(), 0.7F);
  EXPECT_LT(cone.half_angle(), 0.9F);
}

TEST_F(RoomTest, a_sensor_is_told_at_once_when_somebody_gets_everything) {
  (void)enter(sensor_that_takes_views());
  const auto viewer = enter(viewer_join());
  (void)room.control(viewer, looks_at_the_wall(true), at(1s));
  ASSERT_EQ(watched_from(run_room(room, 2s)).size(), 1U);
  const auto recorder = enter(viewer_join("recorder"), 2s);
  ASSERT_EQ(watched_from(actions).size(), 1U);
  EXPECT_EQ(watched_from(actions)[0].message.watched_from().cones_size(), 0);
  const auto again = watched_from(room.leave(recorder, at(3s)));
  ASSERT_EQ(again.size(), 1U);
  EXPECT_EQ(again[0].message.watched_from().cones_size(), 1);
}

TEST_F(RoomTest, a_moved_sensor_is_not_told_from_where_it_is_looked_at) {
  const auto sensor = enter(sensor_that_takes_views());
  const auto viewer = enter(viewer_join());
  (void)room.control(viewer, looks_at_the_wall(true), at(1s));
  ASSERT_EQ(watched_from(run_room(room, 2s)).size(), 1U);
  pb::Control moved;
  moved.mutable_sensor_moved();
  (void)room.control(sensor, moved, at(2s));
  const auto told = watched_from(run_room(room, 3s));
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].message.watched_from().cones_size(), 0);
}

}  // namespace
}  // namespace roomcast::hub
