// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulate_rig.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>

#include <gtest/gtest.h>

#include "roomcast/source/image_file.h"
#include "roomcast/source/rig_json.h"
#include "roomcast/source/simulator/simulated_source.h"
#include "roomcast/source/source_factory.h"

namespace roomcast {
namespace {

namespace fs = std::filesystem;

class SimulateRig : public testing::Test {
 protected:
  SimulateRig() { fs::remove_all(folder_); }
  ~SimulateRig() override { fs::remove_all(folder_); }

  fs::path folder_ =
      fs::path(testing::TempDir()) / ("simulated_rig_" + std::to_string(std::random_device{}()));
};

DepthImage read_depth(const fs::path& path) {
  ImageFileReader reader;
  DepthImage depth_mm;
  EXPECT_TRUE(reader.read_depth(path, {512, 424}, depth_mm)) << path;
  return depth_mm;
}

TEST_F(SimulateRig, what_it_writes_plays_as_the_live_source_shows_it) {
  SimulateRigOptions options;
  options.sensor_count = 1;
  options.seconds = 0.2;
  options.fps = 15;
  ASSERT_TRUE(simulate_rig(folder_, options));
  SourceOptions playing;
  playing.pace = Pace::kAsFastAsPossible;
  playing.loop = false;
  playing.sim_sensor_count = 1;
  const auto recorded = open_source("rig:" + folder_.string() + "#s0", playing).value();
  const auto live = open_simulated_source("", 0, playing).value();
  const SensorDescription& description = recorded->description();
  EXPECT_EQ(description.name, "s0");
  EXPECT_EQ(description.calibration.depth, live->description().calibration.depth);
  ASSERT_TRUE(description.world_from_depth);
  EXPECT_TRUE(description.world_from_depth->rotation.isApprox(
      live->description().world_from_depth->rotation, 1e-6));
  CapturedFrame played, shown;
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(recorded->next(played, {}).value());
    ASSERT_TRUE(live->next(shown, {}).value());
    EXPECT_EQ(played.depth_mm, shown.depth_mm);
    EXPECT_EQ(played.color.width(), shown.color.width());
  }
  EXPECT_FALSE(recorded->next(played, {}).value());
}

TEST_F(SimulateRig, truth_is_the_recording_without_noise) {
  SimulateRigOptions options;
  options.sensor_count = 1;
  options.seconds = 0.05;
  options.clean = true;
  ASSERT_TRUE(simulate_rig(folder_, options));
  EXPECT_EQ(read_depth(folder_ / "s0/depth/000000.png"),
            read_depth(folder_ / "truth/s0/000000.png"));
  std::ifstream times(folder_ / "truth/s0/times.txt");
  std::string heading, line;
  std::getline(times, heading);
  std::getline(times, line);
  EXPECT_EQ(line, "0 0.000000000");
  std::getline(times, line);
  EXPECT_EQ(line, "1 0.033333333");
}

TEST_F(SimulateRig, truth_holds_masks_and_clean_colour_and_speed_0_stands_still) {
  SimulateRigOptions options;
  options.sensor_count = 1;
  options.seconds = 0.5;
  options.fps = 4;
  options.truth_color = true;
  options.speed = 0;
  ASSERT_TRUE(simulate_rig(folder_, options));
  EXPECT_EQ(read_depth(folder_ / "truth/s0/000000.png"),
            read_depth(folder_ / "truth/s0/000001.png"));
  ImageFileReader reader;
  MaskImage moving;
  ASSERT_TRUE(reader.read_mask(folder_ / "truth/s0/moving/000000.png", {512, 424}, moving));
  const auto count = std::count(moving.data(), moving.data() + moving.view().pixel_count(), 255);
  EXPECT_GT(count, 1000);
  EXPECT_LT(count, 60000);
  EXPECT_TRUE(fs::exists(folder_ / "truth/s0/color/000001.jpg"));
}

TEST_F(SimulateRig, reports_every_picture) {
  SimulateRigOptions options;
  options.sensor_count = 2;
  options.seconds = 0.07;
  int calls = 0, last_total = 0;
  const auto progress = [&](int done, int total) {
    EXPECT_EQ(done, ++calls);
    last_total = total;
  };
  ASSERT_TRUE(simulate_rig(folder_, options, progress));
  EXPECT_EQ(calls, 4);
  EXPECT_EQ(last_total, 4);
  EXPECT_EQ(read_rig_json(folder_ / "rig.json")->sensors.size(), 2U);
}

TEST_F(SimulateRig, impossible_options_are_refused_and_write_nothing) {
  SimulateRigOptions endless, frozen, crowded, nowhere;
  endless.seconds = INFINITY;
  frozen.fps = 0;
  crowded.sensor_count = 9;
  nowhere.scene = "attic";
  for (const auto& options : {endless, frozen, crowded}) {
    const Status status = simulate_rig(folder_, options);
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().code, ErrorCode::kInvalidArgument);
  }
  EXPECT_EQ(simulate_rig(folder_, nowhere).error().code, ErrorCode::kNotFound);
  EXPECT_FALSE(fs::exists(folder_));
}

TEST_F(SimulateRig, a_folder_that_holds_something_is_left_alone) {
  fs::create_directories(folder_);
  std::ofstream(folder_ / "notes.txt") << "mine";
  SimulateRigOptions options;
  options.sensor_count = 1;
  EXPECT_FALSE(simulate_rig(folder_, options));
  EXPECT_FALSE(fs::exists(folder_ / "rig.json"));
}

}  // namespace
}  // namespace roomcast
