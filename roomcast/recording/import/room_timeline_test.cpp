// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/room_timeline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast::recording {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

SensorFileInfo sensor(const char* name, int first_ms, int frames) {
  SensorFileInfo info;
  info.description.name = name;
  info.description.fps = 10;
  for (int i = 0; i < frames; ++i) info.times.push_back(milliseconds(first_ms + 100 * i));
  return info;
}

TEST(RoomTimeline, a_single_sensor_keeps_its_clock) {
  const SensorFileInfo a = sensor("a", 5000, 11);
  const auto line = join_clocks({&a});
  ASSERT_TRUE(line.ok());
  EXPECT_EQ(line->clock_offsets[0], nanoseconds(0));
  EXPECT_EQ(line->start, seconds(5));
  EXPECT_EQ(line->loop_duration, milliseconds(1100));
}

TEST(RoomTimeline, cameras_on_a_sync_cable_share_their_own_clock) {
  SensorFileInfo a = sensor("a", 5000, 11), b = sensor("b", 5300, 11);
  a.clock.is_cable_primary = b.clock.is_cable_secondary = true;
  a.clock.utc_minus_device = seconds(100), b.clock.utc_minus_device = seconds(101);
  const auto line = join_clocks({&a, &b});
  ASSERT_TRUE(line.ok());
  EXPECT_EQ(line->clock, JoiningClock::kCable);
  EXPECT_THAT(line->clock_offsets, testing::ElementsAre(nanoseconds(0), nanoseconds(0)));
  EXPECT_EQ(line->loop_duration, milliseconds(1400));
  b.clock = {seconds(101), seconds(2), true, false};  // a second primary: another cable
  EXPECT_EQ(join_clocks({&a, &b})->clock, JoiningClock::kTimeOfDay);
}

TEST(RoomTimeline, others_are_joined_by_the_time_of_day) {
  SensorFileInfo a = sensor("a", 0, 11), b = sensor("b", 900'000, 11);
  a.clock.utc_minus_device = seconds(1'000'000'000);
  b.clock.utc_minus_device = seconds(1'000'000'000 - 900) + milliseconds(500);
  b.clock.utc_error = seconds(2);
  const auto line = join_clocks({&a, &b});
  ASSERT_TRUE(line.ok());
  EXPECT_EQ(line->clock, JoiningClock::kTimeOfDay);
  EXPECT_THAT(line->explanation, testing::HasSubstr("about 2 s"));
  EXPECT_EQ((b.times[0] - line->clock_offsets[1]) - (a.times[0] - line->clock_offsets[0]),
            milliseconds(500));
  EXPECT_EQ(line->start, seconds(1'000'000'000));
}

TEST(RoomTimeline, without_any_common_clock_they_begin_together) {
  SensorFileInfo a = sensor("a", 0, 11), b = sensor("b", 900'000, 11);
  a.clock.utc_minus_device = seconds(5);
  const auto line = join_clocks({&a, &b});
  ASSERT_TRUE(line.ok());
  EXPECT_EQ(line->clock, JoiningClock::kStart);
  EXPECT_EQ(b.times[0] - line->clock_offsets[1], a.times[0] - line->clock_offsets[0]);
}

TEST(RoomTimeline, sensors_of_one_recording_keep_its_clock) {
  SensorFileInfo a = sensor("a", 0, 11), b = sensor("b", 40, 11);
  a.clock.recording = b.clock.recording = "room.mcap";
  const auto line = join_clocks({&a, &b});
  ASSERT_TRUE(line.ok());
  EXPECT_EQ(line->clock, JoiningClock::kRecording);
  EXPECT_THAT(line->clock_offsets, testing::ElementsAre(nanoseconds(0), nanoseconds(0)));
  b.clock.recording = "other.mcap";
  EXPECT_EQ(join_clocks({&a, &b})->clock, JoiningClock::kStart);
}

TEST(RoomTimeline, a_clock_that_is_not_there_and_recordings_of_different_days_are_refused) {
  SensorFileInfo a = sensor("a", 0, 11), b = sensor("b", 0, 11);
  EXPECT_EQ(join_clocks({&a, &b}, JoiningClock::kCable).error().code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(join_clocks({&a, &b}, JoiningClock::kTimeOfDay).error().code,
            ErrorCode::kInvalidArgument);
  a.clock.utc_minus_device = seconds(0);
  b.clock.utc_minus_device = seconds(86'400);
  const auto apart = join_clocks({&a, &b});
  ASSERT_FALSE(apart.ok());
  EXPECT_THAT(apart.error().message, testing::HasSubstr("86399.0 s after"));
  EXPECT_TRUE(join_clocks({&a, &b}, JoiningClock::kStart).ok());
}

}  // namespace
}  // namespace roomcast::recording
