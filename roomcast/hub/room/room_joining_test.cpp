// SPDX-License-Identifier: Apache-2.0
// The clients that may join a Room, their roles, and the messages that they get first.
#include "roomcast/hub/room/room.h"
#include "roomcast/hub/room/room_test_fixture.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub {
namespace {

using testing::IsEmpty;

TEST_F(RoomTest, sensors_get_ids_in_order_of_their_first_coming) {
  const auto first = enter(sensor_join("left"));
  EXPECT_THAT(all<AcceptConnection>(actions), testing::SizeIs(1));
  EXPECT_EQ(messages(actions, pb::Control::kWelcome)[0].to, std::vector{first});
  EXPECT_EQ(messages(actions, pb::Control::kWelcome)[0].message.welcome().sensor_id(), 0u);
  enter(sensor_join("right"));
  EXPECT_EQ(messages(actions, pb::Control::kWelcome)[0].message.welcome().sensor_id(), 1u);
  EXPECT_EQ(room.online_sensor_count(), 2u);
}

TEST_F(RoomTest, a_sensor_that_comes_back_has_the_same_id_and_pose) {
  enter(viewer_join());
  const auto left = enter(sensor_join("left", pose_at(7)));
  enter(sensor_join("right"));
  const auto roster_without = newest_roster(room.leave(left, at(1s)));
  EXPECT_FALSE(roster_without.sensors(0).online());
  EXPECT_EQ(roster_without.sensors(0).world_from_depth(3), 7);
  enter(sensor_join("left", std::nullopt), 2s);
  const auto roster = newest_roster(actions);
  EXPECT_TRUE(roster.sensors(0).online());
  EXPECT_EQ(roster.sensors(0).name(), "left");
  EXPECT_EQ(roster.sensors(0).world_from_depth(3), 7);
  EXPECT_EQ(roster.sensors(0).placement(), pb::PLACEMENT_GIVEN);
}

TEST_F(RoomTest, a_sensor_that_joins_twice_replaces_its_old_connection) {
  const auto old_connection = enter(sensor_join("left"));
  const auto new_connection = enter(sensor_join("left"));
  const auto disconnected = all<Disconnect>(actions);
  ASSERT_EQ(disconnected.size(), 1u);
  EXPECT_EQ(disconnected[0].connection, old_connection);
  EXPECT_EQ(disconnected[0].code, pb::ERROR_REPLACED);
  EXPECT_EQ(room.online_sensor_count(), 1u);
  EXPECT_THAT(room.leave(old_connection, at(1s)), IsEmpty())
      << "the old connection's end changes nothing";
  EXPECT_TRUE(all<Disconnect>(frame(new_connection, SensorId{0}, 1s, 1s)).empty());
}

TEST_F(RoomTest, a_viewer_is_welcomed_with_a_place_and_the_roster) {
  enter(sensor_join("left"));
  const auto viewer = enter(viewer_join("Ada"));
  const auto welcome = messages(actions, pb::Control::kWelcome);
  ASSERT_EQ(welcome.size(), 1u);
  EXPECT_EQ(welcome[0].message.welcome().room(), "lab");
  EXPECT_EQ(welcome[0].message.welcome().start_pose_size(), 16);
  const auto roster = newest_roster(actions);
  EXPECT_EQ(roster.sensors(0).name(), "left");
  EXPECT_EQ(roster.viewers(0).name(), "Ada");
  EXPECT_EQ(messages(actions, pb::Control::kRoster)[0].to, std::vector{viewer});
  EXPECT_EQ(roster.fps(), 30);
}

TEST_F(RoomTest, nobody_sends_under_the_name_of_a_sensor_that_is_here_with_another_token) {
  enter(sensor_join("left"), 0s, {.token_id = "one"});
  enter(sensor_join("left"), 1s, {.token_id = "another"});
  EXPECT_EQ(all<Disconnect>(actions).at(0).code, pb::ERROR_WRONG_ROLE);
  EXPECT_EQ(all<Disconnect>(actions).size(), 1U) << "who was here stays";
  enter(sensor_join("left"), 2s);
  EXPECT_EQ(all<Disconnect>(actions).at(0).code, pb::ERROR_WRONG_ROLE);
}

TEST_F(RoomTest, the_same_token_one_for_this_name_and_an_admins_replace_a_sensor) {
  enter(sensor_join("left"), 0s, {.token_id = "one"});
  enter(sensor_join("left"), 1s, {.token_id = "one"});
  EXPECT_EQ(all<Disconnect>(actions).at(0).code, pb::ERROR_REPLACED);
  enter(sensor_join("left"), 2s, {.token_id = "another", .takes_over_name = true});
  EXPECT_EQ(all<Disconnect>(actions).at(0).code, pb::ERROR_REPLACED);
}

TEST_F(RoomTest, a_sensor_that_has_gone_leaves_its_name_to_others) {
  const auto first = enter(sensor_join("left"), 0s, {.token_id = "one"});
  (void)room.leave(first, at(1s));
  enter(sensor_join("left"), 2s, {.token_id = "another"});
  EXPECT_THAT(all<Disconnect>(actions), IsEmpty());
}

TEST_F(RoomTest, a_smaller_room_holds_fewer) {
  actions = room.change({.name = "lab", .max_sensors = 1, .max_viewers = 1}, at(0s));
  enter(sensor_join("left"));
  enter(sensor_join("right"));
  EXPECT_EQ(all<Disconnect>(actions).at(0).code, pb::ERROR_ROOM_FULL);
  enter(sensor_join("left"));
  EXPECT_EQ(all<Disconnect>(actions).at(0).code, pb::ERROR_REPLACED) << "it is known already";
  enter(viewer_join());
  enter(viewer_join());
  EXPECT_EQ(all<Disconnect>(actions).at(0).code, pb::ERROR_ROOM_FULL);
}

TEST_F(RoomTest, viewers_enter_where_the_rooms_owner_says) {
  actions = room.change(
      {.name = "lab", .start_positions = {{.x_m = 3, .z_m = 4}, {.x_m = 5, .z_m = 6}}}, at(0s));
  for (const double x : {3, 5, 3}) {
    enter(viewer_join());
    const auto welcome = messages(actions, pb::Control::kWelcome).at(0).message.welcome();
    EXPECT_EQ(welcome.start_pose(3), x);
  }
}

TEST_F(RoomTest, a_welcome_says_what_a_viewer_may_do) {
  enter(viewer_join(), 0s,
        {.may_place = true, .may_record = true, .may_share = true, .new_token = "t"});
  const auto welcome = messages(actions, pb::Control::kWelcome).at(0).message.welcome();
  EXPECT_TRUE(welcome.may_place());
  EXPECT_TRUE(welcome.may_record());
  EXPECT_TRUE(welcome.may_export());
  EXPECT_EQ(welcome.token(), "t");
}

TEST_F(RoomTest, a_room_holds_so_many_sensors_and_viewers_and_no_more) {
  for (std::size_t i = 0; i < wire::kMaxSensors; ++i) enter(sensor_join("s" + std::to_string(i)));
  EXPECT_THAT(all<Disconnect>(actions), IsEmpty());
  enter(sensor_join("one more"));
  EXPECT_EQ(all<Disconnect>(actions)[0].code, pb::ERROR_ROOM_FULL);
  for (std::size_t i = 0; i < kUsualMaxViewers; ++i) enter(viewer_join());
  EXPECT_THAT(all<Disconnect>(actions), IsEmpty());
  enter(viewer_join());
  EXPECT_EQ(all<Disconnect>(actions)[0].code, pb::ERROR_ROOM_FULL);
}

TEST_F(RoomTest, a_modeler_gets_key_frames_and_is_nobody_in_the_room) {
  const auto sensor = enter(sensor_join("left"));
  const auto modeler = enter(modeler_join());
  EXPECT_EQ(all<AcceptConnection>(actions).at(0).role, Role::kModeler);
  const auto details = all<SetDetails>(actions).at(0);
  EXPECT_EQ(details.viewer, modeler);
  EXPECT_EQ(detail_of(details.details, SensorId{wire::kMaxSensors - 1}), Detail::kKeyFrames);
  EXPECT_EQ(newest_roster(actions).sensors_size(), 1);
  EXPECT_EQ(newest_roster(actions).viewers_size(), 0);
  EXPECT_FALSE(room.stats().frames_wanted) << "no sensor sends for it";
  EXPECT_EQ(room.viewer_count(), 0u);
  EXPECT_THAT(room.connections(), UnorderedElementsAre(sensor, modeler));
  pb::Control request;
  request.mutable_key_request()->set_sensor_id(0);
  const auto asked = room.control(modeler, request, at(500ms));
  EXPECT_THAT(messages(asked, pb::Control::kKeyRequest).at(0).to, ElementsAre(sensor));
  const auto left = room.leave(sensor, at(1s));
  EXPECT_THAT(messages(left, pb::Control::kRoster).at(0).to, ElementsAre(modeler));
  (void)room.leave(modeler, at(2s));
  EXPECT_THAT(room.connections(), IsEmpty());
}

TEST_F(RoomTest, a_sensor_is_asked_for_key_frames_once_something_has_gone_if_there_is_a_modeler) {
  const auto sensor = enter(sensor_join("left"));
  enter(viewer_join());
  const auto sees = [&](std::uint32_t near_cm, nanoseconds now) {
    pb::Control control;
    auto& depth = *control.mutable_coarse_depth();
    depth.set_columns(1);
    depth.set_rows(1);
    depth.add_near_cm(near_cm);
    depth.add_far_cm(400);
    (void)room.control(sensor, control, at(now));
  };
  const auto asked_at = [&](nanoseconds now) {
    return !messages(frame(sensor, SensorId{0}, now, now, false), pb::Control::kKeyRequest).empty();
  };
  sees(250, 1s);
  sees(400, 5s);
  EXPECT_FALSE(asked_at(5s)) << "nobody keeps a model";
  enter(modeler_join(), 6s);
  for (const auto now : {6s, 7s, 8s}) {
    EXPECT_TRUE(asked_at(now));
    (void)frame(sensor, SensorId{0}, now + 100ms, now + 100ms);
  }
  EXPECT_FALSE(asked_at(9s)) << "three are enough";
}

TEST_F(RoomTest, has_place_for_few_modelers) {
  for (std::size_t i = 0; i < wire::kMaxModelers; ++i) enter(modeler_join());
  const auto refused = room.join(ConnectionId{99}, modeler_join(), {}, at(0s));
  EXPECT_EQ(all<Disconnect>(refused).at(0).code, pb::ERROR_ROOM_FULL);
}

}  // namespace
}  // namespace roomcast::hub
