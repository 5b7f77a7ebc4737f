// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/room.h"

#include <array>

#include "roomcast/hub/room/room_test_fixture.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

TEST_F(RoomTest, a_sensor_without_a_pose_is_shown_but_not_called_placed) {
  enter(viewer_join());
  enter(sensor_join("left", std::nullopt));
  const auto roster = newest_roster(actions);
  EXPECT_EQ(roster.sensors(0).placement(), pb::PLACEMENT_UNPLACED);
  EXPECT_EQ(roster.sensors(0).world_from_depth_size(), 16);
}

TEST_F(RoomTest, rosters_go_to_all_viewers_and_their_revision_grows) {
  const auto a = enter(viewer_join());
  const auto first = newest_roster(actions).revision();
  const auto b = enter(viewer_join(), 1s);
  EXPECT_THAT(messages(actions, pb::Control::kRoster)[0].to, UnorderedElementsAre(a, b));
  EXPECT_GT(newest_roster(actions).revision(), first);
  const auto after = newest_roster(room.leave(a, at(2s)));
  EXPECT_EQ(after.viewers_size(), 1);
}

TEST_F(RoomTest, a_class_that_arrives_at_once_is_announced_once) {
  const auto first = enter(viewer_join());
  for (int i = 1; i < 30; ++i) {
    const auto viewer = enter(viewer_join(), 1ms);
    const auto rosters = messages(actions, pb::Control::kRoster);
    ASSERT_EQ(rosters.size(), 1U);
    EXPECT_THAT(rosters[0].to, ElementsAre(viewer)) << "who arrives is told at once";
    EXPECT_EQ(newest_roster(actions).viewers_size(), i + 1);
  }
  ASSERT_TRUE(room.next_tick());
  EXPECT_EQ(*room.next_tick(), at(wire::kRosterInterval));
  EXPECT_TRUE(messages(room.tick(at(50ms)), pb::Control::kRoster).empty());
  const auto rosters = messages(room.tick(at(wire::kRosterInterval)), pb::Control::kRoster);
  ASSERT_EQ(rosters.size(), 1U);
  EXPECT_THAT(rosters[0].to, testing::Contains(first));
  EXPECT_EQ(rosters[0].message.roster().viewers_size(), 30);
  EXPECT_TRUE(messages(room.tick(at(1s)), pb::Control::kRoster).empty());
}

TEST_F(RoomTest, a_sensor_is_announced_before_its_first_frame_however_many_come_and_go) {
  const auto viewer = enter(viewer_join());
  enter(sensor_join("left"), 1ms);
  EXPECT_THAT(messages(actions, pb::Control::kRoster).at(0).to, ElementsAre(viewer));
}

TEST_F(RoomTest, a_late_viewer_makes_all_sensors_send_key_frames) {
  const auto left = enter(sensor_join("left"));
  const auto right = enter(sensor_join("right"));
  enter(viewer_join());
  std::vector<ConnectionId> asked;
  for (const auto& request : messages(actions, pb::Control::kKeyRequest))
    asked.push_back(request.to[0]);
  EXPECT_THAT(asked, UnorderedElementsAre(left, right));
}

TEST_F(RoomTest, key_requests_are_paced_and_none_is_forgotten) {
  enter(sensor_join("left"));
  enter(viewer_join(), 0ms);
  EXPECT_EQ(messages(actions, pb::Control::kKeyRequest).size(), 1u);
  EXPECT_THAT(room.key_needed(SensorId{0}, at(100ms)), IsEmpty());
  EXPECT_EQ(room.next_tick(), at(500ms));
  EXPECT_EQ(messages(room.tick(at(500ms)), pb::Control::kKeyRequest).size(), 1u);
  EXPECT_THAT(room.key_needed(SensorId{99}, at(2s)), IsEmpty())
      << "an unknown sensor is nobody's problem";
}

TEST_F(RoomTest, a_frame_goes_to_the_viewers_as_a_set) {
  const auto sensor = enter(sensor_join("left"));
  EXPECT_THAT(all<SendSet>(frame(sensor, SensorId{0}, 0ms, 5ms)), IsEmpty()) << "nobody is there";
  enter(viewer_join());
  const auto sets = all<SendSet>(frame(sensor, SensorId{0}, 33ms, 38ms));
  ASSERT_EQ(sets.size(), 1u);
  EXPECT_EQ(sets[0].set->frames.size(), 1u);
}

TEST_F(RoomTest, frames_that_come_together_close_their_set_at_once_and_nothing_waits) {
  const auto left = enter(sensor_join("left"));
  const auto right = enter(sensor_join("right"));
  enter(viewer_join());
  for (int set = 0; set < 3; ++set) {
    std::array together{incoming(left, SensorId{0}, set * 33ms),
                        incoming(right, SensorId{1}, set * 33ms)};
    const auto sets = all<SendSet>(room.frames(together, at(set * 33ms + 5ms)));
    ASSERT_EQ(sets.size(), 1u);
    EXPECT_EQ(sets[0].set->frames.size(), 2u);
  }
}

TEST_F(RoomTest, frames_that_come_together_wait_for_a_sensor_that_is_elsewhere) {
  const auto left = enter(sensor_join("left"));
  const auto right = enter(sensor_join("right"));
  const auto here = enter(sensor_join("here"));
  enter(viewer_join());
  frame(here, SensorId{2}, 0ms, 1ms);
  std::array together{incoming(left, SensorId{0}, 33ms), incoming(right, SensorId{1}, 33ms)};
  EXPECT_THAT(all<SendSet>(room.frames(together, at(34ms))), IsEmpty());
  const auto sets = all<SendSet>(frame(here, SensorId{2}, 33ms, 36ms));
  ASSERT_EQ(sets.size(), 1u);
  EXPECT_EQ(sets[0].set->frames.size(), 3u);
}

TEST_F(RoomTest, of_frames_that_come_together_only_the_wrong_ones_are_refused) {
  const auto left = enter(sensor_join("left"));
  const auto right = enter(sensor_join("right"));
  enter(viewer_join());
  std::array together{incoming(left, SensorId{1}, 0ms), incoming(right, SensorId{1}, 0ms)};
  const auto out = room.frames(together, at(5ms));
  ASSERT_EQ(all<Disconnect>(out).size(), 1u);
  EXPECT_EQ(all<Disconnect>(out)[0].connection, left);
  EXPECT_EQ(all<SendSet>(out).size(), 1u);
}

TEST_F(RoomTest, stats_count_frames_and_sets_and_tell_the_skew) {
  const auto left = enter(sensor_join("left"));
  const auto right = enter(sensor_join("right"));
  frame(left, SensorId{0}, 0ms, 20ms);
  frame(right, SensorId{1}, 4ms, 21ms);
  frame(left, SensorId{0}, 33ms, 50ms);
  (void)room.tick(at(200ms));
  const RoomStats stats = room.stats();
  EXPECT_EQ(stats.sets, 2U);
  EXPECT_EQ(stats.incomplete_sets, 1U) << "nobody waits for a sensor before its first frame";
  EXPECT_NEAR(stats.set_skew_s, 0.029, 1e-9);
  ASSERT_EQ(stats.sensors.size(), 2U);
  EXPECT_EQ(stats.sensors[0].frames, 2U);
  EXPECT_EQ(stats.sensors[0].bytes, 2 * wire::kFrameHeaderBytes);
  EXPECT_NEAR(stats.sensors[0].delay_s, 0.017, 1e-9);
  EXPECT_TRUE(stats.sensors[1].online);
}

TEST_F(RoomTest, a_set_that_waits_is_sent_by_the_clock) {
  const auto left = enter(sensor_join("left"));
  const auto right = enter(sensor_join("right"));
  enter(viewer_join());
  frame(left, SensorId{0}, 0ms, 0ms);
  frame(right, SensorId{1}, 0ms, 0ms);
  EXPECT_THAT(all<SendSet>(frame(left, SensorId{0}, 33ms, 34ms)), IsEmpty());
  EXPECT_EQ(room.next_tick(), at(50ms));
  EXPECT_THAT(all<SendSet>(room.tick(at(50ms))), testing::SizeIs(1));
}

TEST_F(RoomTest, frames_from_strangers_or_under_another_id_or_from_the_future_end_the_connection) {
  const auto sensor = enter(sensor_join("left"));
  const auto viewer = enter(viewer_join());
  EXPECT_EQ(all<Disconnect>(frame(viewer, SensorId{0}, 0s, 0s))[0].code, pb::ERROR_UNEXPECTED);
  EXPECT_EQ(all<Disconnect>(frame(sensor, SensorId{1}, 0s, 0s))[0].code, pb::ERROR_UNEXPECTED);
  EXPECT_EQ(room.online_sensor_count(), 0u);
  const auto again = enter(sensor_join("left"));
  EXPECT_EQ(
      all<Disconnect>(frame(again, SensorId{0}, 0s + wire::kMaxCaptureAhead + 1ms, 0s))[0].code,
      pb::ERROR_MALFORMED);
}

TEST_F(RoomTest, what_a_frame_would_be_refused_for_is_known_before_it_goes_to_other_hubs) {
  const auto sensor = enter(sensor_join("left"));
  const wire::FrameHeader own{.sensor = SensorId{0}, .capture_time = at(0s)};
  const wire::FrameHeader anothers{.sensor = SensorId{1}, .capture_time = at(0s)};
  EXPECT_FALSE(room.fault_of(sensor, own, at(0s)).has_value());
  EXPECT_EQ(room.fault_of(sensor, anothers, at(0s))->code, pb::ERROR_UNEXPECTED);
  EXPECT_EQ(room.fault_of(ConnectionId{99}, own, at(0s))->code, pb::ERROR_UNEXPECTED);
  EXPECT_EQ(room.online_sensor_count(), 1u) << "asking changes nothing";
}

TEST_F(RoomTest, sensors_and_viewers_are_told_where_else_the_room_is_now_and_when_they_come) {
  const auto sensor = enter(sensor_join("left"));
  pb::Join join;
  join.mutable_aligner();
  const auto speaker = enter(join);
  pb::Control others;
  others.mutable_other_hubs()->add_urls("wss://b");
  const auto told = messages(room.control(speaker, others, at(1s)), pb::Control::kOtherHubs);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_THAT(told[0].to, UnorderedElementsAre(sensor));
  const auto viewer = enter(viewer_join());
  ASSERT_EQ(messages(actions, pb::Control::kOtherHubs).size(), 1u);
  EXPECT_EQ(all<Disconnect>(room.control(viewer, others, at(1s))).at(0).code, pb::ERROR_UNEXPECTED)
      << "a viewer sends nobody elsewhere";
}

pb::Control pose_message(float x) {
  pb::Control control;
  control.mutable_viewer_pose()->set_viewer_id(12345);  // a forged ID; the hub replaces it
  control.mutable_viewer_pose()->mutable_head()->set_x(x);
  return control;
}

TEST_F(RoomTest, poses_are_relayed_to_all_viewers) {
  const auto a = enter(viewer_join(), -1s);
  const auto b = enter(viewer_join());
  EXPECT_THAT(room.control(a, pose_message(2), at(20ms)), IsEmpty());
  const auto sent = messages(room.tick(at(30ms)), pb::Control::kViewerPoses);
  ASSERT_EQ(sent.size(), 1u);
  EXPECT_THAT(sent[0].to, UnorderedElementsAre(a, b));
  EXPECT_EQ(sent[0].message.viewer_poses().poses(0).viewer_id(), 1u);
  EXPECT_EQ(room.next_tick(), std::nullopt);
}

TEST_F(RoomTest, a_new_viewer_learns_where_those_stand_who_do_not_move) {
  const auto a = enter(viewer_join());
  EXPECT_THAT(room.control(a, pose_message(1), at(0ms)), IsEmpty());
  EXPECT_EQ(room.tick(at(0ms)).size(), 1u);
  enter(viewer_join(), 1s);
  EXPECT_EQ(messages(room.tick(at(1s)), pb::Control::kViewerPoses).size(), 1u);
}

TEST_F(RoomTest, messages_of_the_wrong_role_end_the_connection) {
  const auto sensor = enter(sensor_join("left"));
  EXPECT_EQ(all<Disconnect>(room.control(sensor, pose_message(1), at(0s)))[0].code,
            pb::ERROR_UNEXPECTED);
  const auto viewer = enter(viewer_join());
  pb::Control roster;
  roster.mutable_roster();
  EXPECT_EQ(all<Disconnect>(room.control(viewer, roster, at(0s)))[0].code, pb::ERROR_UNEXPECTED);
  EXPECT_EQ(room.viewer_count(), 0u);
}

TEST_F(RoomTest, an_unknown_kind_of_message_is_ignored) {
  const auto viewer = enter(viewer_join());
  EXPECT_THAT(room.control(viewer, pb::Control(), at(0s)), IsEmpty());
}

TEST_F(RoomTest, tells_who_is_in_it_and_how_they_do) {
  const auto sensor = enter(sensor_join("left"), 0s, {.token_id = "one"});
  const auto viewer = enter(viewer_join("Ada"), 0s, {.token_id = "two"});
  pb::Control told;
  told.mutable_viewer_stats()->set_latency_ms(80);
  (void)room.control(viewer, told, at(1s));
  const RoomStats stats = room.stats();
  EXPECT_EQ(stats.sensors.at(0).token_id, "one");
  EXPECT_EQ(stats.sensors.at(0).connection, sensor);
  EXPECT_EQ(stats.viewers.at(0).name, "Ada");
  EXPECT_EQ(stats.viewers.at(0).latency_ms, 80);
  EXPECT_THAT(room.connections(), testing::UnorderedElementsAre(sensor, viewer));
}

}  // namespace
}  // namespace roomcast::hub
