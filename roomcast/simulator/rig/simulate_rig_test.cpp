// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/rig/simulate_rig.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <stop_token>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/io/image_file.h"
#include "roomcast/recording/dataset/rig_json.h"
#include "roomcast/recording/playback/recording_source.h"
#include "roomcast/simulator/sensing/sensor_unit.h"
#include "roomcast/simulator/simulated_source.h"

namespace roomcast::simulator {
namespace {

namespace fs = std::filesystem;

class SimulateRig : public testing::Test {
 protected:
  const TemporaryFolder scratch_;
  const fs::path folder_ = scratch_ / "rig";
};

DepthImage read_depth(const fs::path& path) {
  io::ImageFileReader reader;
  DepthImage depth_mm;
  EXPECT_TRUE(reader.read_depth(path, {512, 424}, depth_mm)) << path;
  return depth_mm;
}

std::vector<std::string> lines_of(const fs::path& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    if (line[0] != '#') lines.push_back(line);
  }
  return lines;
}

/// A short recording of one sensor with small colour and no free views.
SimulateRigOptions brief() {
  SimulateRigOptions options;
  options.scene = "office";
  options.sensor_count = 1;
  options.seconds = 0.2;
  options.fps = 15;
  options.sensing.half_color = true;
  options.views = 0;
  return options;
}

TEST_F(SimulateRig, its_recording_equals_the_live_source) {
  SimulateRigOptions options = brief();
  options.timing = simulator::TimingOptions::perfect();
  ASSERT_TRUE(simulate_rig(folder_, options));
  const auto recorded =
      recording::open_rig_source(folder_.string(), "s0",
                                 {.pace = source::Pace::kAsFastAsPossible, .loop = false})
          .value();
  const auto live = open_simulated_source(
                        "office", 0, {.pace = source::Pace::kAsFastAsPossible, .sensor_count = 1})
                        .value();
  const source::SensorDescription& description = recorded->description();
  EXPECT_EQ(description.name, "s0");
  EXPECT_EQ(description.calibration.depth, live->description().calibration.depth);
  ASSERT_TRUE(description.world_from_depth);
  EXPECT_TRUE(description.world_from_depth->rotation.isApprox(
      live->description().world_from_depth->rotation, 1e-6));
  source::CapturedFrame played, shown;
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(recorded->next(played, {}).value());
    ASSERT_TRUE(live->next(shown, {}).value());
    EXPECT_EQ(played.depth_mm, shown.depth_mm);
    EXPECT_EQ(played.color.width(), shown.color.width());
  }
  EXPECT_FALSE(recorded->next(played, {}).value());
}

TEST_F(SimulateRig, truth_is_the_recording_without_noise) {
  SimulateRigOptions options = brief();
  options.seconds = 0.15;
  options.clean();
  ASSERT_TRUE(simulate_rig(folder_, options));
  EXPECT_EQ(read_depth(folder_ / "s0/depth/000000.png"),
            read_depth(folder_ / "truth/s0/000000.png"));
  EXPECT_EQ(lines_of(folder_ / "truth/s0/times.txt"),
            (std::vector<std::string>{"0 0.000000000", "1 0.066666667"}));
  EXPECT_EQ(lines_of(folder_ / "truth/s0/gains.txt"),
            (std::vector<std::string>{"0 1.00000 1.00000 1.00000", "1 1.00000 1.00000 1.00000"}));
}

TEST_F(SimulateRig, truth_has_masks_and_clean_colour_and_nothing_moves_at_speed_0) {
  SimulateRigOptions options = brief();
  options.truth_color = true;
  options.speed = 0;
  options.timing = simulator::TimingOptions::perfect();
  ASSERT_TRUE(simulate_rig(folder_, options));
  EXPECT_EQ(read_depth(folder_ / "truth/s0/000000.png"),
            read_depth(folder_ / "truth/s0/000001.png"));
  io::ImageFileReader reader;
  MaskImage moving;
  ASSERT_TRUE(reader.read_mask(folder_ / "truth/s0/moving/000000.png", {512, 424}, moving));
  const auto count = std::count(moving.data(), moving.data() + moving.view().pixel_count(), 255);
  EXPECT_GT(count, 1000);
  EXPECT_LT(count, 60000);
  ColorImage clean, noisy;
  ASSERT_TRUE(reader.read_color(folder_ / "truth/s0/color/000001.jpg", {960, 540}, clean));
  ASSERT_TRUE(reader.read_color(folder_ / "s0/rgb/000001.jpg", {960, 540}, noisy));
  double squares = 0;
  for (std::size_t i = 0; i < clean.view().pixel_count(); ++i) {
    const double error = clean.data()[i].g - noisy.data()[i].g;
    squares += error * error;
  }
  const double rms = std::sqrt(squares / static_cast<double>(clean.view().pixel_count()));
  EXPECT_GT(rms, 0.5);  // grey levels: camera noise plus JPEG noise
  EXPECT_LT(rms, 4.0);
}

TEST_F(SimulateRig, clocks_and_losses_are_those_in_rig_json) {
  SimulateRigOptions options = brief();
  options.sensor_count = 2;
  options.seconds = 2;
  options.timing.lost_share = 0.2;
  ASSERT_TRUE(simulate_rig(folder_, options));
  const recording::RigDescription rig = recording::read_rig_json(folder_ / "rig.json").value();
  std::size_t lost = 0;
  for (const recording::RigSensorEntry& sensor : rig.sensors) {
    const fs::path folder = folder_ / sensor.path;
    const auto truth = lines_of(folder_ / "truth" / sensor.path / "times.txt");
    ASSERT_EQ(truth.size(), 30U);
    std::size_t listed = 0;
    const auto stamps = lines_of(folder / "depth.txt");
    for (std::size_t frame = 0; frame < truth.size(); ++frame) {
      const bool dropped = std::count(sensor.drop.begin(), sensor.drop.end(), frame) > 0;
      char name[32];
      std::snprintf(name, sizeof(name), "depth/%06zu.png", frame);
      EXPECT_EQ(fs::exists(folder / name), !dropped);
      EXPECT_TRUE(fs::exists(folder_ / "truth" / sensor.path / (name + 6)));
      if (dropped) continue;
      ASSERT_LT(listed, stamps.size());
      const std::string& line = stamps[listed++];
      EXPECT_NE(line.find(name), std::string::npos);
      const double true_time_s = std::stod(truth[frame].substr(truth[frame].find(' ')));
      EXPECT_NEAR(std::stod(line) - true_time_s, sensor.clock_offset_s,
                  2.0 * options.timing.jitter_s + 1e-6);
    }
    EXPECT_EQ(listed, stamps.size());
    EXPECT_GT(std::abs(sensor.clock_offset_s), 0.0);
    lost += sensor.drop.size();
  }
  EXPECT_GE(lost, 3U);
  EXPECT_LE(lost, 25U);
}

TEST_F(SimulateRig, free_views_lie_in_the_truth_with_the_frames_nearest_to_them) {
  SimulateRigOptions options = brief();
  options.views = 1;
  options.view_side_px = 120;
  ASSERT_TRUE(simulate_rig(folder_, options));
  std::ifstream file(folder_ / "truth/views.json");
  const auto views = nlohmann::json::parse(file);
  ASSERT_EQ(views["views"].size(), 2U);
  const auto& view = views["views"][1];
  EXPECT_EQ(view["color"], "view_0_t1.png");
  EXPECT_EQ(view["frame"]["s0"], 2);
  EXPECT_EQ(view["frame_minus_view_s"]["s0"], 0.0);
  EXPECT_EQ(view["world_from_view"].size(), 16U);
  io::ImageFileReader reader;
  DepthImage depth_mm;
  MaskImage seen;
  ASSERT_TRUE(reader.read_depth(folder_ / "truth/view_0_t1_depth.png", {120, 120}, depth_mm));
  ASSERT_TRUE(reader.read_mask(folder_ / "truth/view_0_t1_seen.png", {120, 120}, seen));
  const auto covered = std::count(seen.data(), seen.data() + seen.view().pixel_count(), 1);
  EXPECT_GT(covered, 120 * 120 / 5);
}

/// The name and contents of every file.
std::map<std::string, std::string> contents_of(const fs::path& folder) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::ifstream file(entry.path(), std::ios::binary);
    contents[entry.path().lexically_relative(folder).string()] =
        std::string(std::istreambuf_iterator<char>(file), {});
  }
  return contents;
}

TEST_F(SimulateRig, same_seed_gives_the_same_bytes_on_one_and_on_two_threads) {
  SimulateRigOptions options = brief();
  options.sensor_count = 2;
  options.truth_color = true;
  options.sensing.interference_per_minute = 30;
  options.threads = 1;
  ASSERT_TRUE(simulate_rig(folder_ / "one", options));
  options.threads = 2;
  ASSERT_TRUE(simulate_rig(folder_ / "two", options));
  const auto one = contents_of(folder_ / "one"), two = contents_of(folder_ / "two");
  EXPECT_GT(one.size(), 20U);
  ASSERT_EQ(one.size(), two.size());
  for (const auto& [name, bytes] : one) EXPECT_TRUE(two.at(name) == bytes) << name;
  options.seed = 2;
  options.sensor_count = 1;
  ASSERT_TRUE(simulate_rig(folder_ / "other", options));
  EXPECT_NE(contents_of(folder_ / "other").at("s0/depth/000000.png"),
            one.at("s0/depth/000000.png"));
}

TEST_F(SimulateRig, the_truth_of_harsh_sensors_has_their_scales_and_lenses) {
  SimulateRigOptions options = brief();
  options.sensor_count = 2;
  options.sensing.harsh = Harshness::kStructuredLight;
  ASSERT_TRUE(simulate_rig(folder_, options));
  std::ifstream file(folder_ / "truth/rig.json"), reported_file(folder_ / "rig.json");
  const auto truth = nlohmann::json::parse(file), reported = nlohmann::json::parse(reported_file);
  for (int i = 0; i < 2; ++i) {
    SensingOptions sensing = options.sensing;
    const SensorUnit unit = make_unit(sensing, options.seed, i);
    const auto& sensor = truth["sensors"][static_cast<std::size_t>(i)];
    EXPECT_EQ(sensor["depth_scale"].get<double>(), unit.depth_scale);
    EXPECT_EQ(sensor["camera"], "kinect1");
    EXPECT_FALSE(reported["sensors"][static_cast<std::size_t>(i)].contains("depth_scale"));
    const fs::path camera = sensor["path"].get<std::string>() + "/camera.json";
    std::ifstream exact_file(folder_ / "truth" / camera), declared_file(folder_ / camera);
    const auto exact = nlohmann::json::parse(exact_file),
               declared = nlohmann::json::parse(declared_file);
    EXPECT_NEAR(exact["depth"]["fx"].get<double>(), unit.exact.depth.fx, 1e-6);
    EXPECT_EQ(declared["depth"]["fx"].get<double>(), 585);
  }
  EXPECT_TRUE(recording::read_rig_json(folder_ / "truth/rig.json"));
}

TEST_F(SimulateRig, reports_every_picture) {
  SimulateRigOptions options = brief();
  options.sensor_count = 2;
  int calls = 0, last_total = 0;
  const auto watcher = [&](const SimulateProgress& progress) {
    if (progress.doing != "writing frames") return;
    EXPECT_EQ(progress.done, ++calls);
    last_total = progress.total;
  };
  ASSERT_TRUE(simulate_rig(folder_, options, watcher));
  EXPECT_EQ(calls, 6);
  EXPECT_EQ(last_total, 6);
  EXPECT_EQ(recording::read_rig_json(folder_ / "rig.json")->sensors.size(), 2U);
}

TEST_F(SimulateRig, stopped_it_leaves_a_shorter_recording) {
  std::stop_source stop;
  const auto watcher = [&](const SimulateProgress& progress) {
    if (progress.doing == "writing frames" && progress.done == 2) stop.request_stop();
  };
  const Status status = simulate_rig(folder_, brief(), watcher, stop.get_token());
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kClosed);
  EXPECT_EQ(lines_of(folder_ / "s0/depth.txt").size(), 2U);
  EXPECT_EQ(recording::read_rig_json(folder_ / "rig.json")->source.find("not finished"),
            std::string::npos);
}

TEST_F(SimulateRig, a_failure_leaves_nothing_behind) {
  fs::create_directories(folder_);
  const auto watcher = [&](const SimulateProgress& progress) {
    if (progress.doing == "writing frames") fs::remove_all(folder_ / "truth");
  };
  const Status status = simulate_rig(folder_, brief(), watcher);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kUnavailable);
  EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(SimulateRig, impossible_options_are_refused_and_write_nothing) {
  SimulateRigOptions endless = brief(), frozen = brief(), crowded = brief(), hasty = brief(),
                     blind = brief(), lossy = brief(), nowhere = brief();
  endless.seconds = INFINITY;
  frozen.fps = 0;
  crowded.sensor_count = 9;
  hasty.speed = 11;
  blind.views = -1;
  lossy.timing.lost_share = 0.9;
  nowhere.scene = "attic";
  for (const auto& options : {endless, frozen, crowded, hasty, blind, lossy}) {
    const Status status = simulate_rig(folder_, options);
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().code, ErrorCode::kInvalidArgument);
  }
  EXPECT_EQ(simulate_rig(folder_, nowhere).error().code, ErrorCode::kNotFound);
  EXPECT_FALSE(fs::exists(folder_));
}

TEST_F(SimulateRig, a_folder_with_files_is_refused) {
  fs::create_directories(folder_);
  std::ofstream(folder_ / "notes.txt") << "mine";
  EXPECT_FALSE(simulate_rig(folder_, brief()));
  EXPECT_TRUE(fs::exists(folder_ / "notes.txt"));
  EXPECT_FALSE(fs::exists(folder_ / "rig.json"));
}

}  // namespace
}  // namespace roomcast::simulator
