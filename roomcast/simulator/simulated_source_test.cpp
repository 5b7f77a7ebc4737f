// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/simulated_source.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <thread>

#include <gtest/gtest.h>

#include "roomcast/simulator/simulated_sensor.h"

namespace roomcast::simulator {
namespace {

using std::chrono::milliseconds;

SimulatedSourceOptions as_fast_as_possible() {
  SimulatedSourceOptions options;
  options.pace = source::Pace::kAsFastAsPossible;
  return options;
}

TEST(SimulatedSource, describes_its_sensor) {
  SimulatedSourceOptions options = as_fast_as_possible();
  options.fps = 12;
  const auto source = open_simulated_source("office", 1, options).value();
  EXPECT_EQ(source->description().name, "s1");
  EXPECT_EQ(source->description().fps, 12);
  ASSERT_TRUE(source->description().world_from_depth);
  EXPECT_GT(source->description().world_from_depth->translation_m.y(), 1.2);
  EXPECT_EQ(source->description().calibration.depth.width, 512);
}

TEST(SimulatedSource, frames_count_from_scene_time_zero_at_the_requested_rate) {
  const auto source = open_simulated_source("", 2, as_fast_as_possible()).value();
  source::CapturedFrame frame;
  for (int i = 0; i < 4; ++i) {
    ASSERT_TRUE(source->next(frame, {}).value());
    EXPECT_EQ(frame.index, static_cast<std::uint64_t>(i));
    EXPECT_NEAR(std::chrono::duration<double>(frame.capture_time.time_since_epoch()).count(),
                i / 15.0, 1e-9);
  }
}

TEST(SimulatedSource, frame_is_what_the_sensor_reports_of_its_instant) {
  const auto source = open_simulated_source("office,speed=0.5", 0, as_fast_as_possible()).value();
  SimulatedSensor::Options options;
  options.speed = 0.5;
  options.sensing.half_color = true;
  const auto sensor =
      SimulatedSensor::open(SimulatedRoom::build("office", 1).value(), options).value();
  auto moment = sensor->make_moment();
  auto control = sensor->auto_exposure();
  source::CapturedFrame frame;
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(source->next(frame, {}).value());
    const nanoseconds time = frame.capture_time.time_since_epoch();
    const float exposure = sensor->next_exposure(time, moment, control);
    DepthImage depth_mm;
    ColorImage color;
    sensor->look(time, moment);
    sensor->read_depth(frame.index, moment, depth_mm);
    sensor->read_color(frame.index, exposure, moment, color);
    EXPECT_EQ(frame.depth_mm, depth_mm);
    EXPECT_EQ(frame.color, color);
  }
}

TEST(SimulatedSource, a_cabinet_goes_to_and_fro) {
  SimulatedSourceOptions options = as_fast_as_possible();
  options.fps = 2;
  const auto moved =
      open_simulated_source("livingroom,speed=0,clean,cabinet=1", 0, options).value();
  source::CapturedFrame frame;
  std::vector<DepthImage> depths;
  for (int i = 0; i < 6; ++i) {
    ASSERT_TRUE(moved->next(frame, {}).value());
    depths.push_back(frame.depth_mm);
  }
  EXPECT_EQ(depths[0], depths[1]) << "of the first second";
  EXPECT_FALSE(depths[1] == depths[2]);
  EXPECT_EQ(depths[2], depths[3]);
  EXPECT_EQ(depths[4], depths[0]);
}

TEST(SimulatedSource, a_bump_moves_the_sensor_once) {
  SimulatedSourceOptions options = as_fast_as_possible();
  options.fps = 2;
  const auto still = open_simulated_source("bare,speed=0,clean", 0, options).value();
  const auto bumped =
      open_simulated_source("bare,speed=0,clean,bump_at=1,bump_cm=5", 0, options).value();
  source::CapturedFrame one, other;
  for (int i = 0; i < 4; ++i) {
    ASSERT_TRUE(still->next(one, {}).value() && bumped->next(other, {}).value());
    const bool same =
        std::ranges::equal(std::span(one.depth_mm.data(), one.depth_mm.view().pixel_count()),
                           std::span(other.depth_mm.data(), other.depth_mm.view().pixel_count()));
    EXPECT_EQ(same, i < 2) << "frame " << i;
  }
}

TEST(SimulatedSource, real_time_frames_are_instants_of_the_host_clock_that_have_passed) {
  SimulatedSourceOptions options;
  options.fps = 100;
  const auto source = open_simulated_source("", 0, options).value();
  source::CapturedFrame frame;
  HostTime last{};
  for (int i = 0; i < 4; ++i) {
    ASSERT_TRUE(source->next(frame, {}).value());
    EXPECT_LE(frame.capture_time, SteadyClock().now());
    EXPECT_GT(frame.capture_time, last);
    EXPECT_EQ(frame.capture_time.time_since_epoch().count() % 10'000'000, 0);
    last = frame.capture_time;
  }
}

TEST(SimulatedSource, sensors_see_instants_a_fixed_phase_apart) {
  SimulatedSourceOptions options;
  options.fps = 50;
  const auto source = open_simulated_source("", 2, options).value();
  source::CapturedFrame frame;
  ASSERT_TRUE(source->next(frame, {}).value());
  EXPECT_EQ(frame.capture_time.time_since_epoch().count() % 20'000'000, 2 * 2'300'000);
}

TEST(SimulatedSource, stop_ends_the_wait_for_a_frame) {
  SimulatedSourceOptions options;
  options.fps = 0.001;  // the next frame is minutes away
  const auto source = open_simulated_source("", 0, options).value();
  std::stop_source stop;
  source::CapturedFrame frame;
  std::jthread stopper([&] { stop.request_stop(); });
  const auto got = source->next(frame, stop.get_token());
  ASSERT_TRUE(got);
  EXPECT_FALSE(*got);
}

TEST(SimulatedSource, impossible_rates_are_refused) {
  for (const double fps : {0.0, -5.0, 1000.0, std::numeric_limits<double>::quiet_NaN()}) {
    SimulatedSourceOptions options;
    options.fps = fps;
    const auto source = open_simulated_source("", 0, options);
    ASSERT_FALSE(source);
    EXPECT_EQ(source.error().code, ErrorCode::kInvalidArgument);
  }
}

TEST(SimulatedSource, unknown_scenes_and_sensors_are_refused) {
  EXPECT_EQ(open_simulated_source("attic", 0, {}).error().code, ErrorCode::kNotFound);
  EXPECT_EQ(open_simulated_source("", 3, {}).error().code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(open_simulated_source(",fast", 0, {}).error().code, ErrorCode::kInvalidArgument);
}

}  // namespace
}  // namespace roomcast::simulator
