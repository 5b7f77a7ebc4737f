// SPDX-License-Identifier: Apache-2.0
#include "bench/real/rig_judge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/io/file_bytes.h"

namespace roomcast::bench {
namespace {

using testing::HasSubstr;

RigidTransform at_x(double x_m) {
  return {Eigen::Matrix3d::Identity(), {x_m, 0, 0}};
}

alignment::SensorReport placed(const std::string& id, double x_m) {
  alignment::SensorReport sensor;
  sensor.id = id;
  sensor.placed = true;
  sensor.world_from_depth = at_x(x_m);
  sensor.expected_error_mm = 3;
  return sensor;
}

alignment::PairReport pair(const std::string& a, const std::string& b, double x_m) {
  alignment::PairReport report;
  report.a = a;
  report.b = b;
  report.accepted = true;
  report.b_from_a = at_x(x_m);
  return report;
}

class RigJudgeTest : public testing::Test {
 protected:
  RigJudgeTest() { alignment_.sensors = {placed("s0", 0), placed("s1", 1), placed("s2", 2)}; }
  void ball(const std::string& text) {
    ASSERT_TRUE(io::write_file(folder_ / "ball.json", text).ok());
  }
  Result<RigJudgement> judge() const { return judge_rig(folder_ / ".", rig_, alignment_); }

  const TemporaryFolder folder_;
  recording::RigDescription rig_;
  alignment::AlignmentReport alignment_;
};

TEST_F(RigJudgeTest, without_a_judge_nothing_is_judged) {
  const auto judged = judge();
  ASSERT_TRUE(judged.ok());
  EXPECT_TRUE(judged->ball.empty() && judged->known.empty() && judged->loops.empty());
}

TEST_F(RigJudgeTest, the_ball_is_at_two_places_when_a_pose_is_wrong) {
  ball(R"({"ball": [{"sensor": "s0", "frame": 4, "center_in_depth_camera_mm": [500, 0, 2000]},
                    {"sensor": "s1", "frame": 4, "center_in_depth_camera_mm": [-500, 0, 2010]},
                    {"sensor": "s1", "frame": 5, "center_in_depth_camera_mm": [0, 0, 0]}]})");
  const auto judged = judge();
  ASSERT_TRUE(judged.ok()) << judged.error().message;
  ASSERT_EQ(judged->ball.size(), 1U);
  EXPECT_EQ(judged->ball[0].instants, 1U);
  EXPECT_NEAR(judged->ball[0].median_mm, 10, 1e-6);
  EXPECT_NEAR(judged->ball[0].expected_mm, 4.243, 1e-3);
}

TEST_F(RigJudgeTest, the_depth_scale_of_a_sensor_applies_to_its_ball) {
  ball(R"({"ball": [{"sensor": "s0", "frame": 4, "center_in_depth_camera_mm": [500, 0, 2000]},
                    {"sensor": "s1", "frame": 4, "center_in_depth_camera_mm": [-250, 0, 1000]}]})");
  alignment_.sensors[1].depth_scale = 2;
  EXPECT_NEAR(judge()->ball.at(0).median_mm, 0, 1e-6);
}

TEST_F(RigJudgeTest, a_ball_file_of_another_form_is_named) {
  ball(R"({"ball": [{"sensor": "s0", "frame": 4, "center_in_depth_camera_mm": [500]}]})");
  const auto judged = judge();
  ASSERT_FALSE(judged.ok());
  EXPECT_THAT(judged.error().message, HasSubstr("center_in_depth_camera_mm"));
}

TEST_F(RigJudgeTest, poses_are_compared_with_known_ones_wherever_the_world_is) {
  for (const auto& [id, x_m] : {std::pair{"s0", 10.0}, {"s1", 11.02}, {"s2", 12.0}}) {
    recording::RigSensorEntry entry;
    entry.id = id;
    entry.world_from_depth = at_x(x_m);
    rig_.sensors.push_back(entry);
  }
  const auto judged = judge();
  ASSERT_EQ(judged->known.size(), 2U);
  EXPECT_NEAR(judged->known[0].from_known_mm, 20, 1e-6);
  EXPECT_NEAR(judged->known[1].from_known_mm, 0, 1e-6);
}

TEST_F(RigJudgeTest, three_pairs_close_a_loop_up_to_their_errors) {
  alignment_.pairs = {pair("s0", "s1", -1), pair("s1", "s2", -1), pair("s0", "s2", -2.03)};
  const auto judged = judge();
  ASSERT_EQ(judged->loops.size(), 1U);
  EXPECT_NEAR(judged->loops[0].closure_mm, 30, 1e-6);
  alignment_.pairs[2].accepted = false;
  EXPECT_TRUE(judge()->loops.empty());
}

}  // namespace
}  // namespace roomcast::bench
