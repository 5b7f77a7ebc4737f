// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/playback/playback_schedule.h"

#include <gtest/gtest.h>

namespace roomcast::recording {
namespace {

using std::chrono::milliseconds;

constexpr nanoseconds kLoop = milliseconds(100);

HostTime at(int ms) {
  return HostTime(milliseconds(ms));
}
std::vector<nanoseconds> positions(const std::vector<int>& times_ms) {
  std::vector<nanoseconds> all;
  for (const int ms : times_ms) all.push_back(milliseconds(ms));
  return all;
}

void expect_due(PlaybackSchedule& schedule, int now_ms, std::size_t frame, int when_ms) {
  const auto due = schedule.next(at(now_ms));
  ASSERT_TRUE(due);
  EXPECT_EQ(due->frame, frame);
  EXPECT_EQ(due->when, at(when_ms));
}

TEST(PlaybackSchedule, a_loop_plays_the_instant_that_the_host_clock_says) {
  PlaybackSchedule schedule(positions({0, 30, 60}), kLoop, source::Pace::kRealTime, true, at(0));
  expect_due(schedule, 1042, 2, 1060);
  expect_due(schedule, 1060, 0, 1100);
  expect_due(schedule, 1100, 1, 1130);
  expect_due(schedule, 1130, 2, 1160);
}

TEST(PlaybackSchedule, sources_opened_at_different_times_agree) {
  PlaybackSchedule early(positions({0, 30, 60}), kLoop, source::Pace::kRealTime, true, at(3));
  PlaybackSchedule late(positions({0, 30, 60}), kLoop, source::Pace::kRealTime, true, at(777));
  for (int now = 778; now < 1200; now += 30) {
    PlaybackSchedule fresh = late;
    const auto a = fresh.next(at(now));
    std::optional<PlaybackSchedule::Due> b;
    PlaybackSchedule running = early;
    b = running.next(at(now));
    EXPECT_EQ(a->frame, b->frame);
    EXPECT_EQ(a->when, b->when);
  }
}

TEST(PlaybackSchedule, a_frame_that_is_due_now_is_given_now) {
  PlaybackSchedule schedule(positions({0, 30, 60}), kLoop, source::Pace::kRealTime, true, at(0));
  expect_due(schedule, 1030, 1, 1030);
}

TEST(PlaybackSchedule, a_late_caller_gets_the_newest_frame_that_is_due) {
  PlaybackSchedule schedule(positions({0, 30, 60}), kLoop, source::Pace::kRealTime, true, at(0));
  expect_due(schedule, 1000, 0, 1000);
  expect_due(schedule, 1065, 2, 1060);  // frame 1 is skipped
  expect_due(schedule, 1066, 0, 1100);
  expect_due(schedule, 1555, 1, 1530);  // whole rounds are skipped
}

TEST(PlaybackSchedule, a_gap_in_the_recording_stays_a_gap) {
  PlaybackSchedule schedule(positions({0, 10, 80}), kLoop, source::Pace::kRealTime, true, at(0));
  expect_due(schedule, 1000, 0, 1000);
  expect_due(schedule, 1001, 1, 1010);
  expect_due(schedule, 1011, 2, 1080);
}

TEST(PlaybackSchedule, positions_may_lie_beyond_the_loop_as_long_as_they_span_less) {
  PlaybackSchedule schedule(positions({90, 120, 150}), kLoop, source::Pace::kRealTime, true, at(0));
  expect_due(schedule, 1000, 1, 1020);
  expect_due(schedule, 1021, 2, 1050);
  expect_due(schedule, 1051, 0, 1090);
}

TEST(PlaybackSchedule, played_once_it_begins_when_opened_and_ends) {
  PlaybackSchedule schedule(positions({20, 50}), kLoop, source::Pace::kRealTime, false, at(500));
  expect_due(schedule, 500, 0, 500);
  expect_due(schedule, 501, 1, 530);
  EXPECT_FALSE(schedule.next(at(531)));
  EXPECT_FALSE(schedule.next(at(700)));
}

TEST(PlaybackSchedule, played_once_a_very_late_caller_still_gets_the_last_frame) {
  PlaybackSchedule schedule(positions({0, 30, 60}), kLoop, source::Pace::kRealTime, false, at(500));
  expect_due(schedule, 500, 0, 500);
  expect_due(schedule, 9999, 2, 560);
  EXPECT_FALSE(schedule.next(at(9999)));
}

TEST(PlaybackSchedule, as_fast_as_possible_gives_every_frame_in_order) {
  PlaybackSchedule schedule(positions({0, 30, 60}), kLoop, source::Pace::kAsFastAsPossible, true,
                            at(500));
  expect_due(schedule, 5000, 0, 0);
  expect_due(schedule, 9000, 1, 30);
  expect_due(schedule, 9000, 2, 60);
  expect_due(schedule, 9000, 0, 100);
  PlaybackSchedule once(positions({0}), kLoop, source::Pace::kAsFastAsPossible, false, at(500));
  expect_due(once, 500, 0, 0);
  EXPECT_FALSE(once.next(at(500)));
}

}  // namespace
}  // namespace roomcast::recording
