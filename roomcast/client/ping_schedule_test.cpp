// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/ping_schedule.h"

#include <gtest/gtest.h>

namespace roomcast::client {
namespace {

using namespace std::chrono_literals;

TEST(PingSchedule, begins_with_quick_ones_on_every_connection) {
  PingSchedule pace(PingSchedule::kOfSensor, 1);
  for (int connection = 0; connection < 2; ++connection) {
    pace.start_anew();
    for (int i = 0; i < PingSchedule::kOfSensor.quick; ++i)
      EXPECT_EQ(pace.next(), PingSchedule::kQuickPing);
    EXPECT_GT(pace.next(), PingSchedule::kQuickPing);
  }
}

TEST(PingSchedule, comes_ten_times_a_second_at_distances_from_30_to_170_ms) {
  PingSchedule pace(PingSchedule::kOfSensor, 1);
  for (int i = 0; i < PingSchedule::kOfSensor.quick; ++i) (void)pace.next();
  std::chrono::nanoseconds sum{}, shortest = 1h, longest{};
  constexpr int kPings = 1000;
  for (int i = 0; i < kPings; ++i) {
    const auto pause = pace.next();
    sum += pause;
    shortest = std::min(shortest, pause);
    longest = std::max(longest, pause);
  }
  EXPECT_NEAR(static_cast<double>((sum / kPings).count()), 100e6, 5e6);
  EXPECT_GE(shortest, 30ms);
  EXPECT_LT(shortest, 35ms);
  EXPECT_LE(longest, 170ms);
  EXPECT_GT(longest, 165ms);
}

TEST(PingSchedule, of_a_viewer_slows_down_once_the_time_is_known) {
  PingSchedule pace(PingSchedule::kOfViewer, 1);
  for (int i = 0; i < PingSchedule::kOfViewer.settling; ++i) EXPECT_LE(pace.next(), 170ms);
  std::chrono::nanoseconds sum{};
  constexpr int kPings = 1000;
  for (int i = 0; i < kPings; ++i) sum += pace.next();
  EXPECT_NEAR(static_cast<double>((sum / kPings).count()), 500e6, 25e6);
}

TEST(PingSchedule, of_a_hub_asks_a_whole_window_at_once_and_seldom_then) {
  PingSchedule pace(PingSchedule::kOfHub, 1);
  for (int i = 0; i < PingSchedule::kOfHub.quick; ++i)
    EXPECT_EQ(pace.next(), PingSchedule::kQuickPing);
  for (int i = 0; i < 1000; ++i) EXPECT_GE(pace.next(), 150ms);
}

}  // namespace
}  // namespace roomcast::client
