// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/playback/replay_source.h"

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/recording/room/recording_fixture.h"

namespace roomcast::recording {
namespace {

using recording::RecordingFixtureRoom;

class ReplaySourceTest : public testing::Test {
 protected:
  Result<std::unique_ptr<source::FrameSource>> open(
      const std::string& sensor, bool loop = false,
      source::Pace pace = source::Pace::kAsFastAsPossible) const {
    source::PlaybackOptions options;
    options.pace = pace;
    options.loop = loop;
    return open_replay_source(path, sensor, options);
  }

  TemporaryFolder folder;
  std::filesystem::path path = folder / "room.mcap";
};

TEST_F(ReplaySourceTest, gives_every_frame_as_it_was) {
  RecordingFixtureRoom().record(path, 12);
  auto source = open("s1");
  ASSERT_TRUE(source.ok()) << source.error().message;
  source::CapturedFrame frame;
  for (int instant = 0; instant < 12; ++instant) {
    ASSERT_TRUE(*(*source)->next(frame, {}));
    EXPECT_EQ(frame.depth_mm, RecordingFixtureRoom::depth(instant));
    EXPECT_EQ(frame.index, static_cast<std::uint64_t>(instant));
    EXPECT_EQ(frame.device_time, RecordingFixtureRoom::capture(instant));
    ASSERT_EQ(frame.color.width(), RecordingFixtureRoom::kWidth);
    EXPECT_NEAR(frame.color.at(30, 20).r, 160, 6);
  }
  EXPECT_FALSE(*(*source)->next(frame, {}));
}

TEST_F(ReplaySourceTest, knows_where_the_sensor_stood) {
  RecordingFixtureRoom().record(path, 8, true, 5);
  auto source = open("s1");
  const source::SensorDescription& description = (*source)->description();
  EXPECT_EQ(description.name, "s1");
  EXPECT_EQ(description.fps, 10);
  EXPECT_TRUE(description.calibration.color_is_registered);
  ASSERT_TRUE(description.world_from_depth.has_value());
  EXPECT_EQ(description.world_from_depth->translation_m.x(), 0.5);
}

TEST_F(ReplaySourceTest, starts_again_at_the_end) {
  RecordingFixtureRoom().record(path, 3);
  auto source = open("s0", true);
  source::CapturedFrame frame;
  std::vector<HostTime> times;
  for (int i = 0; i < 7; ++i) {
    ASSERT_TRUE(*(*source)->next(frame, {}));
    EXPECT_EQ(frame.depth_mm, RecordingFixtureRoom::depth(i % 3));
    if (!times.empty()) {
      // At the loop's end, the 20 ms between capture and arrival of the last message are added.
      EXPECT_GE(frame.capture_time - times.back(), RecordingFixtureRoom::kPeriod);
      EXPECT_LE(frame.capture_time - times.back(),
                RecordingFixtureRoom::kPeriod + nanoseconds(20'000'000));
    }
    times.push_back(frame.capture_time);
  }
}

TEST_F(ReplaySourceTest, sensors_of_different_rates_begin_again_together) {
  RecordingFixtureRoom().with_last_fps(7).record(path, 3);
  auto first = open("s0", true), second = open("s1", true);
  source::CapturedFrame from_first, from_second;
  for (int i = 0; i < 7; ++i) {
    ASSERT_TRUE(*(*first)->next(from_first, {}));
    ASSERT_TRUE(*(*second)->next(from_second, {}));
    EXPECT_EQ(from_first.capture_time, from_second.capture_time) << i;
  }
}

TEST_F(ReplaySourceTest, a_loop_in_real_time_shows_the_frame_that_is_due) {
  RecordingFixtureRoom().record(path, 20);
  auto source = open("s0", true, source::Pace::kRealTime);
  const HostTime before = SteadyClock().now();
  source::CapturedFrame frame;
  ASSERT_TRUE(*(*source)->next(frame, {}));
  EXPECT_GT(frame.capture_time, before - 2 * RecordingFixtureRoom::kPeriod);
  EXPECT_LT(frame.capture_time, before + std::chrono::seconds(1));
  const nanoseconds length = 20 * RecordingFixtureRoom::kPeriod + nanoseconds(20'000'000);
  const auto position = frame.capture_time.time_since_epoch() % length;
  const auto instant = frame.device_time - RecordingFixtureRoom::capture(0);
  EXPECT_EQ((position - instant) % length, nanoseconds(0));
}

TEST_F(ReplaySourceTest, lists_the_sensors_that_there_are) {
  RecordingFixtureRoom().record(path, 2);
  EXPECT_EQ(*replay_sensor_names(path), (std::vector<std::string>{"s0", "s1"}));
  const auto source = open("s7");
  ASSERT_FALSE(source.ok());
  EXPECT_EQ(source.error().message, "the recording has no sensor \"s7\"; it has s0, s1");
}

}  // namespace
}  // namespace roomcast::recording
