// SPDX-License-Identifier: Apache-2.0
#include "bench/align/frames_suite.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace roomcast::bench {
namespace {

RigidTransform shifted(double x_m) {
  RigidTransform transform;
  transform.translation_m.x() = x_m;
  return transform;
}

/// An answer that puts the second of two sensors at this x.
FramesAnswer second_at(double x_m) {
  FramesAnswer answer{{0, 12}, std::vector<alignment::SensorReport>(2)};
  for (alignment::SensorReport& sensor : answer.sensors) sensor.placed = true;
  answer.sensors[0].world_from_depth = RigidTransform();
  answer.sensors[1].world_from_depth = shifted(x_m);
  answer.sensors[1].expected_error_mm = 7;
  return answer;
}

/// Two sensors, the second one metre to the right of the first.
FramesRig two_sensors() {
  FramesRig rig;
  rig.name = "two";
  rig.sensors = {"s0", "s1"};
  rig.world_from_depth = {RigidTransform(), shifted(1)};
  rig.frames = 30;
  rig.bundle = [](std::size_t, const FrameWindow&) -> Result<alignment::CalibrationBundle> {
    return Error{ErrorCode::kUnavailable, "no frames"};
  };
  return rig;
}

TEST(FramesSuite, windows_are_spread_evenly_over_the_recording) {
  const auto windows = spread_windows(112, {});
  ASSERT_EQ(windows.size(), 20u);
  EXPECT_EQ(windows.front().first, 0u);
  EXPECT_EQ(windows.back().first, 100u);
  for (std::size_t i = 1; i < windows.size(); ++i) {
    EXPECT_NEAR(static_cast<double>(windows[i].first - windows[i - 1].first), 100.0 / 19, 1);
    EXPECT_EQ(windows[i].count, 12u);
  }
}

TEST(FramesSuite, no_window_is_drawn_twice_and_short_recordings_have_one) {
  EXPECT_EQ(spread_windows(16, {}).size(), 5u);
  EXPECT_EQ(spread_windows(13, {}).size(), 2u);
  const auto whole = spread_windows(7, {});
  ASSERT_EQ(whole.size(), 1u);
  EXPECT_EQ(whole[0].count, 7u);
  EXPECT_EQ(spread_windows(112, {1, 12}).front().first, 50u);
}

TEST(FramesSuite, judges_against_the_truth_and_by_the_spread) {
  const auto pairs =
      frames_pairs(two_sensors(), {second_at(1.02), second_at(1.02), second_at(1.32)});
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].answered, 3);
  EXPECT_EQ(pairs[0].wrong, 1);
  EXPECT_NEAR(pairs[0].errors_mm[0], 20, 1e-6);
  EXPECT_NEAR(pairs[0].spread_mm[0], 0, 1e-6);
  EXPECT_NEAR(pairs[0].spread_mm[2], 300, 1e-6);
  EXPECT_EQ(pairs[0].said_mm[0], 7);
}

TEST(FramesSuite, without_truth_nothing_is_wrong_but_the_spread_remains) {
  FramesRig rig = two_sensors();
  rig.world_from_depth[1].reset();
  const auto pairs = frames_pairs(rig, {second_at(1), second_at(2)});
  EXPECT_FALSE(pairs[0].has_truth);
  EXPECT_TRUE(pairs[0].errors_mm.empty());
  EXPECT_EQ(pairs[0].spread_mm.size(), 2u);
}

TEST(FramesSuite, the_ball_is_at_one_place_under_the_true_poses) {
  FramesRig rig = two_sensors();
  rig.ball = {{0, 3, {0.5, 0, 2}}, {1, 3, {-0.5, 0, 2}}, {1, 4, {9, 9, 9}}};
  const auto pairs = frames_pairs(rig, {second_at(1), second_at(1.05)});
  ASSERT_EQ(pairs[0].ball_mm.size(), 2u);
  EXPECT_NEAR(pairs[0].ball_mm[0], 0, 1e-6);
  EXPECT_NEAR(pairs[0].ball_mm[1], 50, 1e-6);
}

TEST(FramesSuite, sensors_without_frames_are_not_placed) {
  const FramesRigRow row = run_frames_suite(two_sensors(), {3, 12}, {});
  EXPECT_EQ(row.draws, 3);
  EXPECT_EQ(row.placed, 0);
  EXPECT_EQ(row.pairs.at(0).answered, 0);
  std::ostringstream json, table;
  print_json({row}, json);
  print_table({row}, table);
  EXPECT_EQ(nlohmann::json::parse(json.str())["rigs"][0]["rig"], "two");
  EXPECT_THAT(table.str(), testing::HasSubstr("0 of 6 sensors placed in 3 draws"));
}

}  // namespace
}  // namespace roomcast::bench
