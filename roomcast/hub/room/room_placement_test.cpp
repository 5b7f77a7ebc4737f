// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/room_test_fixture.h"

namespace roomcast::hub {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

pb::Control bundle_message() {
  pb::Control control;
  control.mutable_calibration_bundle()->set_sensor_id(99);  // a forged ID; the hub replaces it
  control.mutable_calibration_bundle()->set_depth("depth");
  return control;
}

/// The aligner placed "left" from its first bundle. The sensor left at 3 s and is back at 4 s.
class RoomOfOneWhoWasAway : public RoomTest {
 protected:
  ConnectionId enter_placed_leave_and_enter_again(ConnectionId aligner) {
    const auto before = enter(sensor_join("left", std::nullopt));
    (void)room.control(before, bundle_message(), at(1s));
    (void)room.control(aligner, placement_from_bundle(1, 7), at(2s));
    (void)room.leave(before, at(3s));
    return enter(sensor_join("left", std::nullopt), 4s);
  }
};

TEST_F(RoomTest, an_aligner_is_told_of_sensors_and_gets_their_bundles) {
  const auto sensor = enter(sensor_join("left", std::nullopt));
  EXPECT_THAT(room.control(sensor, bundle_message(), at(0s)), IsEmpty()) << "nobody wants it yet";
  const auto aligner = enter(aligner_join());
  EXPECT_EQ(newest_roster(actions).sensors_size(), 1);
  const auto kept = messages(actions, pb::Control::kCalibrationBundle);
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_EQ(kept[0].message.calibration_bundle().sensor_id(), 0U);
  const auto fresh =
      messages(room.control(sensor, bundle_message(), at(1s)), pb::Control::kCalibrationBundle);
  ASSERT_EQ(fresh.size(), 1U);
  EXPECT_THAT(fresh[0].to, ElementsAre(aligner));
  EXPECT_THAT(all<SendSet>(frame(sensor, SensorId{0}, 1s, 1s)), IsEmpty()) << "it gets no frames";
}

TEST_F(RoomTest, what_the_aligner_finds_everyone_is_told) {
  enter(sensor_join("left", std::nullopt));
  enter(viewer_join());
  const auto aligner = enter(aligner_join());
  const auto roster = newest_roster(room.control(aligner, placement_of(0, 7), at(1s)));
  EXPECT_EQ(roster.sensors(0).placement(), pb::PLACEMENT_ALIGNED);
  EXPECT_EQ(roster.sensors(0).world_from_depth(3), 7);
  EXPECT_EQ(roster.sensors(0).expected_error_mm(), 4);
}

TEST_F(RoomTest, who_is_not_placed_is_shown_beside_the_others_and_goes_along_with_them) {
  enter(sensor_join("left", pose_at(1)));
  enter(sensor_join("lost", std::nullopt));
  enter(sensor_join("right", std::nullopt));
  const auto aligner = enter(aligner_join());
  const double alone_m = newest_roster(actions).sensors(1).world_from_depth(3);
  EXPECT_GT(alone_m, 5);
  const auto roster = newest_roster(room.control(aligner, placement_of(2, 9), at(1s)));
  EXPECT_EQ(roster.sensors(1).placement(), pb::PLACEMENT_UNPLACED);
  EXPECT_GT(roster.sensors(1).world_from_depth(3), 9 + 4);
}

TEST_F(RoomTest, what_was_withdrawn_is_shown_beside_the_others_again) {
  enter(sensor_join("left", pose_at(1)));
  enter(sensor_join("right", std::nullopt));
  const auto aligner = enter(aligner_join());
  (void)room.control(aligner, placement_of(1, 2), at(1s));
  pb::Control withdrawn;
  withdrawn.mutable_placements()->add_sensors()->set_sensor_id(1);
  withdrawn.mutable_placements()->mutable_sensors(0)->set_withdrawn(true);
  const auto roster = newest_roster(room.control(aligner, withdrawn, at(2s)));
  EXPECT_EQ(roster.sensors(1).placement(), pb::PLACEMENT_UNPLACED);
  EXPECT_GT(roster.sensors(1).world_from_depth(3), 5);
}

TEST_F(RoomTest, a_sensor_that_cannot_be_placed_stays_where_it_was_and_says_why) {
  enter(sensor_join("left", std::nullopt));
  const auto aligner = enter(aligner_join());
  (void)room.control(aligner, placement_of(0, 7), at(1s));
  pb::Control lost;
  lost.mutable_placements()->add_sensors()->set_note("it shares nothing with the others");
  const auto roster = newest_roster(room.control(aligner, lost, at(2s)));
  EXPECT_EQ(roster.sensors(0).world_from_depth(3), 7);
  EXPECT_EQ(roster.sensors(0).placement_note(), "it shares nothing with the others");
}

pb::Control moved_message() {
  pb::Control control;
  control.mutable_sensor_moved();
  return control;
}

TEST_F(RoomTest, a_sensor_that_was_moved_is_marked_until_it_is_placed_from_what_it_sees_now) {
  const auto sensor = enter(sensor_join("left", std::nullopt));
  const auto aligner = enter(aligner_join());
  (void)room.control(sensor, bundle_message(), at(1s));
  (void)room.control(aligner, placement_from_bundle(1, 7), at(2s));
  auto roster = newest_roster(room.control(sensor, moved_message(), at(10s)));
  EXPECT_TRUE(roster.sensors(0).moved());
  EXPECT_EQ(roster.sensors(0).world_from_depth(3), 7) << "nothing better is known yet";

  roster = newest_roster(room.control(aligner, placement_from_bundle(1, 7.1), at(11s)));
  EXPECT_TRUE(roster.sensors(0).moved()) << "a thought that began before";
  EXPECT_EQ(roster.sensors(0).world_from_depth(3), 7);

  const auto bundle =
      messages(room.control(sensor, bundle_message(), at(12s)), pb::Control::kCalibrationBundle);
  ASSERT_EQ(bundle.at(0).message.calibration_bundle().number(), 2U);
  roster = newest_roster(room.control(aligner, placement_from_bundle(2, 9), at(13s)));
  EXPECT_FALSE(roster.sensors(0).moved());
  EXPECT_EQ(roster.sensors(0).world_from_depth(3), 9);
}

TEST_F(RoomTest, what_a_sensor_saw_before_it_was_moved_no_aligner_is_given) {
  const auto sensor = enter(sensor_join("left", std::nullopt));
  (void)room.control(sensor, bundle_message(), at(1s));
  (void)room.control(sensor, moved_message(), at(2s));
  enter(aligner_join());
  EXPECT_THAT(messages(actions, pb::Control::kCalibrationBundle), IsEmpty());
  EXPECT_TRUE(newest_roster(actions).sensors(0).moved());
}

TEST_F(RoomTest, a_given_pose_holds_until_the_sensor_is_moved) {
  const auto sensor = enter(sensor_join("left", pose_at(1)));
  const auto aligner = enter(aligner_join());
  (void)room.control(sensor, moved_message(), at(1s));
  (void)room.control(sensor, bundle_message(), at(2s));
  const auto roster = newest_roster(room.control(aligner, placement_from_bundle(1, 7), at(3s)));
  EXPECT_EQ(roster.sensors(0).placement(), pb::PLACEMENT_ALIGNED);
  EXPECT_EQ(roster.sensors(0).world_from_depth(3), 7);
}

pb::Control request_for_heads(bool heads) {
  pb::Control control;
  control.mutable_sighting_request()->set_heads(heads);
  return control;
}

TEST_F(RoomTest, sensors_are_asked_to_look_out_also_those_that_come_later) {
  const auto left = enter(sensor_join("left", std::nullopt));
  const auto aligner = enter(aligner_join());
  const auto asked = messages(room.control(aligner, request_for_heads(true), at(1s)),
                              pb::Control::kSightingRequest);
  ASSERT_EQ(asked.size(), 1U);
  EXPECT_THAT(asked[0].to, ElementsAre(left));
  const auto right = enter(sensor_join("right", std::nullopt), 2s);
  const auto asked_too = messages(actions, pb::Control::kSightingRequest);
  ASSERT_EQ(asked_too.size(), 1U);
  EXPECT_THAT(asked_too[0].to, ElementsAre(right));
  EXPECT_TRUE(asked_too[0].message.sighting_request().heads());

  const auto over = messages(room.leave(aligner, at(3s)), pb::Control::kSightingRequest);
  ASSERT_EQ(over.size(), 1U) << "nobody listens any more";
  EXPECT_FALSE(over[0].message.sighting_request().heads());
  enter(sensor_join("third", std::nullopt), 4s);
  EXPECT_THAT(messages(actions, pb::Control::kSightingRequest), IsEmpty());
}

TEST_F(RoomTest, what_sensors_catch_sight_of_aligners_are_told_under_their_own_id) {
  enter(sensor_join("left", std::nullopt));
  const auto right = enter(sensor_join("right", std::nullopt));
  pb::Control seen;
  seen.mutable_sightings()->set_sensor_id(0);  // a forged ID
  seen.mutable_sightings()->add_heads()->set_z(2);
  EXPECT_THAT(room.control(right, seen, at(1s)), IsEmpty()) << "nobody listens";
  const auto aligner = enter(aligner_join());
  const auto passed = messages(room.control(right, seen, at(2s)), pb::Control::kSightings);
  ASSERT_EQ(passed.size(), 1U);
  EXPECT_THAT(passed[0].to, ElementsAre(aligner));
  EXPECT_EQ(passed[0].message.sightings().sensor_id(), 1U);
}

TEST_F(RoomTest, what_a_sensor_saw_at_an_instant_aligners_are_told_under_its_own_id) {
  enter(sensor_join("left", std::nullopt));
  const auto right = enter(sensor_join("right", std::nullopt));
  const auto aligner = enter(aligner_join());
  pb::Control seen;
  seen.mutable_depth_instant()->set_sensor_id(0);  // a forged ID
  seen.mutable_depth_instant()->set_depth("depth");
  const auto passed = messages(room.control(right, seen, at(2s)), pb::Control::kDepthInstant);
  ASSERT_EQ(passed.size(), 1U);
  EXPECT_THAT(passed[0].to, ElementsAre(aligner));
  EXPECT_EQ(passed[0].message.depth_instant().sensor_id(), 1U);
}

pb::Control placement_with_scale(double depth_scale) {
  pb::Control control;
  auto& found = *control.mutable_placements()->add_sensors();
  wire::write_transform(pose_at(5), *found.mutable_world_from_depth());
  found.set_bundle_number(1);
  found.set_depth_scale(depth_scale);
  return control;
}

TEST_F(RoomTest, a_sensor_is_told_the_factor_on_its_readings_that_its_pose_assumes) {
  const auto left = enter(sensor_join("left", std::nullopt));
  const auto aligner = enter(aligner_join());
  const auto told =
      messages(room.control(aligner, placement_with_scale(1.04), at(1s)), pb::Control::kDepthScale);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_THAT(told[0].to, ElementsAre(left));
  EXPECT_EQ(told[0].message.depth_scale().factor(), 1.04);
  EXPECT_THAT(
      messages(room.control(aligner, placement_with_scale(1.04), at(2s)), pb::Control::kDepthScale),
      IsEmpty())
      << "it knows";
  EXPECT_THAT(
      messages(room.control(aligner, placement_with_scale(0), at(3s)), pb::Control::kDepthScale),
      IsEmpty())
      << "an aligner that knows no factors changes none";

  (void)room.leave(left, at(4s));
  const auto again = enter(sensor_join("left", std::nullopt), 5s);
  const auto told_again = messages(actions, pb::Control::kDepthScale);
  ASSERT_EQ(told_again.size(), 1U);
  EXPECT_THAT(told_again[0].to, ElementsAre(again));
}

TEST_F(RoomTest, without_a_factor_a_sensor_is_told_none) {
  enter(sensor_join("left", std::nullopt));
  EXPECT_THAT(messages(actions, pb::Control::kDepthScale), IsEmpty());
  const auto aligner = enter(aligner_join());
  EXPECT_THAT(
      messages(room.control(aligner, placement_with_scale(1), at(1s)), pb::Control::kDepthScale),
      IsEmpty());
}

pb::Control nudge_message() {
  pb::Control control;
  wire::write_transform(pose_at(5), *control.mutable_nudge()->mutable_world_from_depth());
  return control;
}

TEST_F(RoomTest, a_viewer_who_may_place_nudges_and_the_aligner_decides) {
  enter(sensor_join("left", std::nullopt));
  const auto viewer = enter(viewer_join("keeper"), 0s, {.may_place = true});
  const auto aligner = enter(aligner_join());
  const auto passed = messages(room.control(viewer, nudge_message(), at(1s)), pb::Control::kNudge);
  ASSERT_EQ(passed.size(), 1U);
  EXPECT_THAT(passed[0].to, ElementsAre(aligner));
}

TEST_F(RoomTest, nobody_else_nudges) {
  const auto viewer = enter(viewer_join());
  EXPECT_EQ(all<Disconnect>(room.control(viewer, nudge_message(), at(1s))).at(0).code,
            pb::ERROR_UNEXPECTED);
}

TEST_F(RoomTest, an_aligner_passes_on_a_nudge_from_another_hub) {
  const auto aligner = enter(aligner_join());
  EXPECT_EQ(messages(room.control(aligner, nudge_message(), at(1s)), pb::Control::kNudge).size(),
            1u);
}

TEST_F(RoomTest, only_a_sensor_can_say_that_it_was_moved) {
  const auto viewer = enter(viewer_join());
  EXPECT_EQ(all<Disconnect>(room.control(viewer, moved_message(), at(1s))).at(0).code,
            pb::ERROR_UNEXPECTED);
}

TEST_F(RoomTest, a_pose_that_was_given_is_not_aligned_away) {
  enter(sensor_join("left", pose_at(1)));
  const auto aligner = enter(aligner_join());
  const auto roster = newest_roster(room.control(aligner, placement_of(0, 7), at(1s)));
  EXPECT_EQ(roster.sensors(0).placement(), pb::PLACEMENT_GIVEN);
  EXPECT_EQ(roster.sensors(0).world_from_depth(3), 1);
}

TEST_F(RoomTest, an_aligned_pose_survives_the_sensors_coming_and_going) {
  const auto sensor = enter(sensor_join("left", std::nullopt));
  const auto aligner = enter(aligner_join());
  (void)room.control(aligner, placement_of(0, 7), at(1s));
  (void)room.leave(sensor, at(2s));
  enter(sensor_join("left", std::nullopt), 3s);
  EXPECT_EQ(newest_roster(actions).sensors(0).world_from_depth(3), 7);
}

TEST_F(RoomTest, poses_that_were_found_are_kept_and_used_when_the_hub_has_started_again) {
  enter(sensor_join("left", std::nullopt));
  const auto aligner = enter(aligner_join());
  const auto kept = all<SaveSensors>(room.control(aligner, placement_of(0, 7), at(1s)));
  ASSERT_EQ(kept.size(), 1U);
  ASSERT_EQ(kept[0].sensors.size(), 1U);
  EXPECT_EQ(kept[0].sensors[0].name, "left");

  Room restarted({.name = "lab"}, "test");
  restarted.remember({.sensors = kept[0].sensors});
  (void)restarted.join(ConnectionId{1}, viewer_join(), {}, at(0s));
  (void)restarted.join(ConnectionId{2}, sensor_join("right", std::nullopt), {}, at(1s));
  const auto roster =
      newest_roster(restarted.join(ConnectionId{3}, sensor_join("left", std::nullopt), {}, at(2s)));
  EXPECT_EQ(roster.sensors(0).name(), "left");
  EXPECT_EQ(roster.sensors(0).placement(), pb::PLACEMENT_ALIGNED);
  EXPECT_EQ(roster.sensors(0).world_from_depth(3), 7);
  EXPECT_EQ(roster.sensors(1).placement(), pb::PLACEMENT_UNPLACED);
}

TEST_F(RoomTest, a_pose_from_before_a_restart_is_used_at_once_and_said_to_be_unverified) {
  room.remember({.sensors = {{"left", SensorId{0}, stored_pose_at(7, 4)}}});
  const auto aligner = enter(aligner_join());
  const auto sensor = enter(sensor_join("left", std::nullopt));
  EXPECT_EQ(newest_roster(actions).sensors(0).world_from_depth(3), 7);
  EXPECT_TRUE(newest_roster(actions).sensors(0).unverified());
  (void)room.control(sensor, bundle_message(), at(1s));
  const auto roster = newest_roster(room.control(aligner, placement_from_bundle(1, 7), at(2s)));
  EXPECT_FALSE(roster.sensors(0).unverified());
}

TEST_F(RoomOfOneWhoWasAway, a_sensor_that_was_away_may_have_been_moved) {
  const auto aligner = enter(aligner_join());
  const auto sensor = enter_placed_leave_and_enter_again(aligner);
  EXPECT_TRUE(newest_roster(actions).sensors(0).unverified());
  auto other = bundle_message();
  other.mutable_calibration_bundle()->set_depth("of something else");
  EXPECT_THAT(messages(room.control(sensor, other, at(5s)), pb::Control::kRoster), IsEmpty());
  const auto roster = newest_roster(room.control(aligner, placement_from_bundle(2, 7), at(6s)));
  EXPECT_FALSE(roster.sensors(0).unverified());
}

TEST_F(RoomOfOneWhoWasAway, a_sensor_that_only_lost_its_connection_stands_where_it_did) {
  const auto sensor = enter_placed_leave_and_enter_again(enter(aligner_join()));
  const auto roster = newest_roster(room.control(sensor, bundle_message(), at(5s)));
  EXPECT_FALSE(roster.sensors(0).unverified()) << "it has watched its stand all the time";
}

TEST_F(RoomTest, sensors_keep_their_ids_when_the_hub_has_started_again) {
  std::vector<KnownSensor> kept;
  for (const char* name : {"left", "right"}) {
    enter(sensor_join(name));
    for (const auto& keep : all<SaveSensors>(actions)) {
      kept.insert(kept.end(), keep.sensors.begin(), keep.sensors.end());
    }
  }
  Room restarted({.name = "lab"}, "test");
  restarted.remember({.sensors = kept});
  const auto back = restarted.join(ConnectionId{1}, sensor_join("right"), {}, at(0s));
  EXPECT_EQ(messages(back, pb::Control::kWelcome).at(0).message.welcome().sensor_id(), 1U);
  EXPECT_THAT(all<SaveSensors>(back), IsEmpty()) << "nothing new";
}

TEST_F(RoomTest, poses_that_nobody_would_verify_are_not_used) {
  Room alone({.name = "lab"}, "test", false);
  alone.remember({.sensors = {{"left", SensorId{0}, stored_pose_at(7, 4)}}});
  (void)alone.join(ConnectionId{1}, viewer_join(), {}, at(0s));
  const auto roster =
      newest_roster(alone.join(ConnectionId{2}, sensor_join("left", std::nullopt), {}, at(1s)));
  EXPECT_EQ(roster.sensors(0).placement(), pb::PLACEMENT_UNPLACED);
}

TEST_F(RoomTest, strangers_place_nothing) {
  enter(sensor_join("left", std::nullopt));
  const auto viewer = enter(viewer_join());
  EXPECT_EQ(all<Disconnect>(room.control(viewer, placement_of(0, 7), at(1s))).at(0).code,
            pb::ERROR_UNEXPECTED);
}

TEST_F(RoomTest, what_an_aligner_says_of_sensors_that_are_not_there_is_ignored) {
  const auto aligner = enter(aligner_join());
  EXPECT_EQ(newest_roster(room.control(aligner, placement_of(9, 7), at(1s))).sensors_size(), 0);
  EXPECT_THAT(room.leave(aligner, at(2s)), IsEmpty());
}

}  // namespace
}  // namespace roomcast::hub
