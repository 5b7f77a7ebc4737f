// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/room_stats.h"

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

std::uint64_t missed_of(std::vector<std::uint32_t> seqs) {
  SensorStats stats;
  for (const std::uint32_t seq : seqs) count_frame({.seq = seq}, 100, RoomTime(1s), stats);
  return stats.missed;
}

TEST(RoomStats, frames_that_were_numbered_and_did_not_come_are_missed) {
  EXPECT_EQ(missed_of({0, 1, 2}), 0U);
  EXPECT_EQ(missed_of({0, 1, 4, 5, 7}), 3U);
  EXPECT_EQ(missed_of({0xFFFF'FFFE, 0xFFFF'FFFF, 1}), 1U) << "they are counted modulo 2^32";
}

TEST(RoomStats, a_sensor_that_counts_anew_has_left_out_nothing) {
  EXPECT_EQ(missed_of({40, 41, 0, 1}), 0U);
  EXPECT_EQ(missed_of({40, 41, 0, 2}), 1U);
}

}  // namespace
}  // namespace roomcast::hub
