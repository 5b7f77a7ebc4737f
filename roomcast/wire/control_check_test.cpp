// SPDX-License-Identifier: Apache-2.0
#include "roomcast/wire/control_check.h"

#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "roomcast/wire/limits.h"

namespace roomcast::wire {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

void set_identity(google::protobuf::RepeatedField<double>& matrix) {
  matrix.Clear();
  for (int i = 0; i < 16; ++i) matrix.Add(i % 5 == 0 ? 1 : 0);
}

void set_camera(pb::Intrinsics& camera, unsigned width, unsigned height) {
  camera.set_width(width);
  camera.set_height(height);
  camera.set_fx(365);
  camera.set_fy(365);
  camera.set_cx(width / 2.0);
  camera.set_cy(height / 2.0);
}

void set_calibration(pb::Calibration& calibration) {
  set_camera(*calibration.mutable_depth(), 512, 424);
  set_camera(*calibration.mutable_color(), 1920, 1080);
  set_identity(*calibration.mutable_color_from_depth());
}

pb::Control sensor_join() {
  pb::Control control;
  control.mutable_join()->set_name("s0");
  auto& sensor = *control.mutable_join()->mutable_sensor();
  sensor.set_fps(30);
  set_calibration(*sensor.mutable_calibration());
  set_identity(*sensor.mutable_world_from_depth());
  return control;
}

pb::SensorRole& role(pb::Control& control) {
  return *control.mutable_join()->mutable_sensor();
}

struct JoinFault {
  const char* what;
  std::function<void(pb::Control&)> spoil;
};

class FaultyJoin : public testing::TestWithParam<JoinFault> {};

TEST_P(FaultyJoin, is_refused) {
  auto control = sensor_join();
  ASSERT_TRUE(check_control(control).ok());
  GetParam().spoil(control);
  const auto status = check_control(control);
  ASSERT_FALSE(status.ok());
  EXPECT_FALSE(status.error().message.empty());
}

INSTANTIATE_TEST_SUITE_P(
    All, FaultyJoin,
    testing::Values(
        JoinFault{"no_name", [](auto& c) { c.mutable_join()->clear_name(); }},
        JoinFault{"long_name",
                  [](auto& c) { c.mutable_join()->set_name(std::string(kMaxNameBytes + 1, 'a')); }},
        JoinFault{"long_room",
                  [](auto& c) { c.mutable_join()->set_room(std::string(kMaxNameBytes + 1, 'a')); }},
        JoinFault{"no_role", [](auto& c) { c.mutable_join()->clear_role(); }},
        JoinFault{"no_fps", [](auto& c) { role(c).set_fps(0); }},
        JoinFault{"fps_above_limit", [](auto& c) { role(c).set_fps(kMaxFps + 1); }},
        JoinFault{"fps_not_a_number", [](auto& c) { role(c).set_fps(kNan); }},
        JoinFault{"no_calibration", [](auto& c) { role(c).clear_calibration(); }},
        JoinFault{"depth_too_small",
                  [](auto& c) {
                    role(c).mutable_calibration()->mutable_depth()->set_width(kMinDepthSide - 1);
                  }},
        JoinFault{"depth_too_large",
                  [](auto& c) {
                    role(c).mutable_calibration()->mutable_depth()->set_height(kMaxDepthSide + 1);
                  }},
        JoinFault{"color_too_large",
                  [](auto& c) {
                    role(c).mutable_calibration()->mutable_color()->set_width(kMaxImageSide + 1);
                  }},
        JoinFault{"focal_length",
                  [](auto& c) { role(c).mutable_calibration()->mutable_color()->set_fy(0); }},
        JoinFault{"distortion_infinite",
                  [](auto& c) { role(c).mutable_calibration()->mutable_depth()->set_k3(1 / 0.0); }},
        JoinFault{"matrix_short",
                  [](auto& c) { role(c).mutable_world_from_depth()->RemoveLast(); }},
        JoinFault{"matrix_scaled", [](auto& c) { role(c).set_world_from_depth(5, 1.1); }},
        JoinFault{"matrix_mirrored", [](auto& c) { role(c).set_world_from_depth(5, -1); }},
        JoinFault{"matrix_not_a_number", [](auto& c) { role(c).set_world_from_depth(3, kNan); }},
        JoinFault{"matrix_last_row", [](auto& c) { role(c).set_world_from_depth(12, 1); }},
        JoinFault{"position_far_away",
                  [](auto& c) { role(c).set_world_from_depth(3, kMaxPosition_m * 2); }}),
    [](const auto& test) { return test.param.what; });

TEST(ControlCheck, a_sensor_need_not_know_where_it_is) {
  auto control = sensor_join();
  role(control).clear_world_from_depth();
  EXPECT_TRUE(check_control(control).ok());
}

TEST(ControlCheck, a_viewer_needs_no_name) {
  pb::Control control;
  control.mutable_join()->mutable_viewer();
  EXPECT_TRUE(check_control(control).ok());
}

pb::Control viewer_pose() {
  pb::Control control;
  control.mutable_viewer_pose()->mutable_head()->set_qw(1);
  return control;
}

TEST(ControlCheck, poses_need_a_head_a_unit_quaternion_and_a_place_in_reach) {
  EXPECT_TRUE(check_control(viewer_pose()).ok());
  auto headless = viewer_pose();
  headless.mutable_viewer_pose()->clear_head();
  EXPECT_FALSE(check_control(headless).ok());
  auto scaled = viewer_pose();
  scaled.mutable_viewer_pose()->mutable_left_hand()->set_qw(2);
  EXPECT_FALSE(check_control(scaled).ok());
  auto pointing = viewer_pose();
  pointing.mutable_viewer_pose()->mutable_pointer()->mutable_to()->set_x(3);
  EXPECT_TRUE(check_control(pointing).ok());
  pointing.mutable_viewer_pose()->mutable_pointer()->mutable_to()->set_x(2 * kMaxPosition_m);
  EXPECT_FALSE(check_control(pointing).ok());
  auto nowhere = viewer_pose();
  nowhere.mutable_viewer_pose()->mutable_head()->set_y(std::numeric_limits<float>::quiet_NaN());
  EXPECT_FALSE(check_control(nowhere).ok());
}

TEST(ControlCheck, a_roster_is_bounded_and_its_entries_are_checked) {
  pb::Control control;
  auto& sensor = *control.mutable_roster()->add_sensors();
  sensor.set_name("s0");
  sensor.set_fps(30);
  set_calibration(*sensor.mutable_calibration());
  set_identity(*sensor.mutable_world_from_depth());
  EXPECT_TRUE(check_control(control).ok());
  sensor.set_id(70'000);
  EXPECT_FALSE(check_control(control).ok());
  sensor.set_id(1);
  for (std::size_t i = 0; i < kMaxViewers; ++i) control.mutable_roster()->add_viewers();
  EXPECT_TRUE(check_control(control).ok());
  control.mutable_roster()->add_viewers();
  EXPECT_FALSE(check_control(control).ok());
}

TEST(ControlCheck, presence_and_revocations_between_hubs_are_bounded_and_checked) {
  pb::Control people;
  auto& here = *people.mutable_people_here();
  for (int i = 0; i < kMaxPeopleHere; ++i) here.add_people()->set_name("Ada");
  EXPECT_TRUE(check_control(people).ok());
  here.mutable_people(0)->set_name("line\nbreak");
  EXPECT_FALSE(check_control(people).ok());
  here.mutable_people(0)->clear_name();
  here.add_people();
  EXPECT_FALSE(check_control(people).ok());

  pb::Control revoked;
  auto& tokens = *revoked.mutable_revoked_tokens();
  for (int i = 0; i < kMaxRevokedTokens; ++i) tokens.add_tokens()->set_id("t");
  EXPECT_TRUE(check_control(revoked).ok());
  tokens.mutable_tokens(0)->clear_id();
  EXPECT_FALSE(check_control(revoked).ok());
  tokens.mutable_tokens(0)->set_id("t");
  tokens.add_tokens()->set_id("t");
  EXPECT_FALSE(check_control(revoked).ok());
}

TEST(ControlCheck, a_bundle_has_depth_and_a_direction_that_is_one) {
  pb::Control control;
  auto& bundle = *control.mutable_calibration_bundle();
  EXPECT_FALSE(check_control(control).ok());
  bundle.set_depth("bytes");
  EXPECT_TRUE(check_control(control).ok());
  for (const double number : {0.0, -1.0}) bundle.add_up(number);
  EXPECT_FALSE(check_control(control).ok());
  bundle.add_up(0);
  EXPECT_TRUE(check_control(control).ok());
  bundle.set_up(1, kNan);
  EXPECT_FALSE(check_control(control).ok());
}

TEST(ControlCheck, sightings_are_bounded_in_number_and_place) {
  pb::Control control;
  auto& head = *control.mutable_sightings()->add_heads();
  head.set_z(2);
  auto& tag = *control.mutable_sightings()->add_tags();
  for (int i = 0; i < 12; ++i) tag.add_corners(1.5F);
  EXPECT_TRUE(check_control(control));
  tag.set_corners(4, std::numeric_limits<float>::quiet_NaN());
  EXPECT_FALSE(check_control(control));
  tag.mutable_corners()->RemoveLast();
  EXPECT_FALSE(check_control(control));
  control.mutable_sightings()->clear_tags();
  for (int i = 0; i < kMaxSightings; ++i) control.mutable_sightings()->add_heads();
  EXPECT_EQ(check_control(control).error().code, ErrorCode::kTooLarge);
  control.mutable_sightings()->clear_heads();
  control.mutable_sightings()->add_heads()->set_x(1e30F);
  EXPECT_FALSE(check_control(control));
}

TEST(ControlCheck, a_nudge_has_a_rigid_pose) {
  pb::Control control;
  control.mutable_nudge()->set_sensor_id(3);
  EXPECT_FALSE(check_control(control));
  for (int i = 0; i < 16; ++i) control.mutable_nudge()->add_world_from_depth(i % 5 == 0);
  EXPECT_TRUE(check_control(control));
}

TEST(ControlCheck, placements_are_rigid_and_bounded_and_may_be_none) {
  pb::Control control;
  auto& placement = *control.mutable_placements()->add_sensors();
  placement.set_note("turn it towards another");
  EXPECT_TRUE(check_control(control).ok());
  set_identity(*placement.mutable_world_from_depth());
  EXPECT_TRUE(check_control(control).ok());
  placement.set_expected_error_mm(-1);
  EXPECT_FALSE(check_control(control).ok());
  placement.set_expected_error_mm(4);
  placement.set_world_from_depth(5, 2);
  EXPECT_FALSE(check_control(control).ok());
  placement.set_world_from_depth(5, 1);
  placement.set_note(std::string(kMaxNoteBytes + 1, 'x'));
  EXPECT_FALSE(check_control(control).ok());
  placement.clear_note();
  for (std::size_t i = 0; i < kMaxSensors; ++i) control.mutable_placements()->add_sensors();
  EXPECT_FALSE(check_control(control).ok());
}

TEST(ControlCheck, a_token_and_a_code_have_an_end) {
  pb::Control control;
  control.mutable_join()->mutable_aligner();
  control.mutable_join()->set_token(std::string(kMaxTokenBytes, 'x'));
  EXPECT_TRUE(check_control(control).ok());
  control.mutable_join()->set_token(std::string(kMaxTokenBytes + 1, 'x'));
  EXPECT_EQ(check_control(control).error().code, ErrorCode::kTooLarge);
  control.mutable_join()->clear_token();
  control.mutable_join()->set_code(std::string(kMaxNameBytes + 1, 'x'));
  EXPECT_FALSE(check_control(control).ok());
}

TEST(ControlCheck, voices_are_at_most_as_many_as_viewers) {
  pb::Control control;
  auto& voices = *control.mutable_voices();
  for (std::size_t i = 0; i < kMaxViewers; ++i) voices.add_speaking(1);
  EXPECT_TRUE(check_control(control).ok());
  voices.add_speaking(1);
  EXPECT_FALSE(check_control(control).ok());
  voices.clear_speaking();
  for (std::size_t i = 0; i <= kMaxViewers; ++i) voices.add_muted(1);
  EXPECT_FALSE(check_control(control).ok());
}

TEST(ControlCheck, other_hubs_are_few_and_have_short_plain_addresses) {
  pb::Control control;
  for (int i = 0; i < kMaxOtherHubs; ++i) {
    control.mutable_other_hubs()->add_urls(std::string(kMaxUrlBytes, 'x'));
  }
  EXPECT_TRUE(check_control(control).ok());
  control.mutable_other_hubs()->add_urls("x");
  EXPECT_FALSE(check_control(control).ok());
  control.mutable_other_hubs()->clear_urls();
  for (const std::string& url : {std::string(kMaxUrlBytes + 1, 'x'), std::string("a b")}) {
    control.mutable_other_hubs()->clear_urls();
    control.mutable_other_hubs()->add_urls(url);
    EXPECT_FALSE(check_control(control).ok());
  }
}

TEST(ControlCheck, ids_and_statistics_are_checked) {
  pb::Control key_request;
  key_request.mutable_key_request()->set_sensor_id(65'536);
  EXPECT_FALSE(check_control(key_request).ok());
  pb::Control stats;
  stats.mutable_viewer_stats()->set_latency_ms(std::numeric_limits<float>::infinity());
  EXPECT_FALSE(check_control(stats).ok());
  pb::Control health;
  health.mutable_sensor_health()->set_flickering(0.1F);
  health.mutable_sensor_health()->set_noise_ratio(2);
  EXPECT_TRUE(check_control(health).ok());
  health.mutable_sensor_health()->set_flickering(1.1F);
  EXPECT_FALSE(check_control(health).ok());
  health.mutable_sensor_health()->set_flickering(std::numeric_limits<float>::quiet_NaN());
  EXPECT_FALSE(check_control(health).ok());
}

TEST(ControlCheck, a_factor_on_readings_is_about_one) {
  pb::Control control;
  for (const double factor : {0.5, 1.0, 2.0}) {
    control.mutable_depth_scale()->set_factor(factor);
    EXPECT_TRUE(check_control(control).ok()) << factor;
  }
  for (const double factor : {0.0, -1.0, 0.49, 2.01, kNan}) {
    control.mutable_depth_scale()->set_factor(factor);
    EXPECT_FALSE(check_control(control).ok()) << factor;
  }
}

TEST(ControlCheck, an_instant_needs_depth_and_a_factor_that_makes_sense) {
  pb::Control control;
  auto& instant = *control.mutable_depth_instant();
  EXPECT_FALSE(check_control(control).ok());
  instant.set_depth("depth");
  EXPECT_TRUE(check_control(control).ok());
  instant.set_depth_scale(3);
  EXPECT_FALSE(check_control(control).ok());
  instant.set_depth_scale(1);
  instant.set_sensor_id(1u << 16);
  EXPECT_FALSE(check_control(control).ok());
}

TEST(ControlCheck, placements_and_bundles_with_senseless_factors_are_refused) {
  pb::Control placements;
  placements.mutable_placements()->add_sensors()->set_depth_scale(kNan);
  EXPECT_FALSE(check_control(placements).ok());
  pb::Control bundle;
  bundle.mutable_calibration_bundle()->set_depth("depth");
  EXPECT_TRUE(check_control(bundle).ok());
  bundle.mutable_calibration_bundle()->set_depth_scale(0.1);
  EXPECT_FALSE(check_control(bundle).ok());
}

TEST(ControlCheck, who_plays_a_recording_does_nothing_else) {
  pb::Control control;
  pb::ViewerRole& viewer = *control.mutable_join()->mutable_viewer();
  viewer.set_plays(std::string(kMaxRecordingNameBytes, 'r'));
  EXPECT_TRUE(check_control(control).ok());
  viewer.set_records(true);
  EXPECT_FALSE(check_control(control).ok());
  viewer.set_records(false);
  viewer.set_relays(true);
  EXPECT_FALSE(check_control(control).ok());
  viewer.set_relays(false);
  for (const std::string& name :
       {std::string(kMaxRecordingNameBytes + 1, 'r'), std::string("a\nb")}) {
    viewer.set_plays(name);
    EXPECT_FALSE(check_control(control).ok()) << name;
  }
}

}  // namespace
}  // namespace roomcast::wire
