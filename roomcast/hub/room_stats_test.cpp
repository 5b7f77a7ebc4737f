// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room_stats.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::Not;

FrameSet set_of(std::vector<std::pair<std::uint16_t, nanoseconds>> captures) {
  FrameSet set;
  for (const auto& [sensor, time] : captures) {
    set.frames.push_back({{.sensor = SensorId{sensor}, .capture_time = RoomTime(time)}, nullptr});
  }
  return set;
}

TEST(RoomStats, skew_is_from_first_to_last_capture_of_the_sensors) {
  EXPECT_EQ(capture_skew(set_of({{0, 100ms}, {1, 112ms}, {2, 105ms}})), 12ms);
  EXPECT_EQ(capture_skew(set_of({{0, 100ms}})), 0ms);
  EXPECT_EQ(capture_skew({}), 0ms);
}

TEST(RoomStats, of_a_sensor_that_catches_up_the_newest_frame_counts) {
  const FrameSet set = set_of({{0, 30ms}, {0, 97ms}, {1, 100ms}});
  EXPECT_EQ(capture_skew(set), 3ms);
  EXPECT_EQ(sensor_count(set), 2U);
}

TEST(RoomStats, text_is_what_prometheus_reads) {
  RoomStats stats{
      .room = "lab", .viewers = 3, .sets = 40, .incomplete_sets = 2, .set_skew_s = 0.012};
  stats.sensors.push_back({.name = "left", .online = true, .frames = 41, .bytes = 900});
  const std::string text = metrics_text(stats, 7);
  EXPECT_THAT(text, HasSubstr("# TYPE roomcast_sensor_frames_total counter\n"
                              "roomcast_sensor_frames_total{room=\"lab\",sensor=\"left\"} 41\n"));
  EXPECT_THAT(text, HasSubstr("roomcast_viewers{room=\"lab\"} 3\n"));
  EXPECT_THAT(text, HasSubstr("roomcast_set_skew_seconds{room=\"lab\"} 0.012\n"));
  EXPECT_THAT(text, HasSubstr("roomcast_dropped_sets_total{room=\"lab\"} 7\n"));
  EXPECT_THAT(text, Not(HasSubstr("sensor_clock_error_seconds{"))) << "it is not known";
}

TEST(RoomStats, names_cannot_break_out_of_their_quotes) {
  RoomStats stats{.room = "lab"};
  stats.sensors.push_back({.name = "a\"} 1\\"});
  EXPECT_THAT(metrics_text(stats, 0), HasSubstr("sensor=\"a\\\"} 1\\\\\"}"));
}

}  // namespace
}  // namespace roomcast::hub
