// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/frames_rig.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/recording/dataset/recording_fixture.h"
#include "roomcast/simulator/rig/simulate_rig.h"

namespace roomcast::cli {
namespace {

namespace fs = std::filesystem;

class FramesRigFolder : public testing::Test {
 protected:
  void SetUp() override {
    simulator::SimulateRigOptions options;
    options.scene = "office";
    options.sensor_count = 1;
    options.seconds = 0.4;
    options.fps = 10;
    options.sensing.half_color = true;
    options.views = 0;
    options.timing.lost_share = 0;
    ASSERT_TRUE(simulator::simulate_rig(folder_, options));
  }
  void write_ball(const std::string& text) const { std::ofstream(folder_ / "ball.json") << text; }

  const TemporaryFolder scratch_;
  const fs::path folder_ = scratch_ / "rig";
};

TEST_F(FramesRigFolder, has_its_truth_its_ball_and_bundles_of_windows) {
  write_ball(R"({"ball": [{"sensor": "s0", "frame": 2,
                 "center_in_depth_camera_mm": [100, -200, 3000]}]})");
  const auto rig = read_frames_rig(folder_);
  ASSERT_TRUE(rig) << rig.error().message;
  EXPECT_EQ(rig->sensors, std::vector<std::string>{"s0"});
  EXPECT_EQ(rig->frames, 4u);
  EXPECT_TRUE(rig->world_from_depth.at(0));
  ASSERT_EQ(rig->ball.size(), 1u);
  EXPECT_EQ(rig->ball[0].frame, 2u);
  EXPECT_TRUE(rig->ball[0].center_m.isApprox(Eigen::Vector3d(0.1, -0.2, 3)));
  const auto early = rig->bundle(0, {0, 1}), late = rig->bundle(0, {3, 1});
  ASSERT_TRUE(early && late);
  EXPECT_NE(early->depth_mm, late->depth_mm);
  EXPECT_FALSE(rig->bundle(0, {4, 12})) << "beyond the end";
}

TEST_F(FramesRigFolder, a_wrong_ball_file_is_refused_by_name) {
  for (const char* text :
       {R"({"ball": [{"sensor": "s9", "frame": 0, "center_in_depth_camera_mm": [0, 0, 1]}]})",
        R"({"ball": [{"sensor": "s0", "frame": -1, "center_in_depth_camera_mm": [0, 0, 1]}]})",
        R"({"ball": [{"sensor": "s0", "frame": 0, "center_in_depth_camera_mm": [0, 1]}]})",
        R"({"ball": 3})", "nonsense"}) {
    write_ball(text);
    const auto rig = read_frames_rig(folder_);
    ASSERT_FALSE(rig) << text;
    EXPECT_THAT(rig.error().message, testing::HasSubstr("ball.json"));
  }
}

TEST(FramesRig, a_missing_rig_is_an_error) {
  EXPECT_FALSE(read_frames_rig("/nonexistent"));
}

TEST(FramesRig, reads_the_ball_of_the_three_kinects) {
  const fs::path folder = recording::shared_data() / "kinects3";
  if (!fs::exists(folder)) GTEST_SKIP() << "no recordings at " << recording::shared_data();
  const auto rig = read_frames_rig(folder);
  ASSERT_TRUE(rig) << rig.error().message;
  EXPECT_EQ(rig->sensors.size(), 3u);
  EXPECT_EQ(rig->frames, 36u);
  EXPECT_GT(rig->ball.size(), 60u);
  EXPECT_FALSE(rig->world_from_depth.at(0)) << "nobody knows where they stand";
}

}  // namespace
}  // namespace roomcast::cli
