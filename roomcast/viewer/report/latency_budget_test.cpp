// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/report/latency_budget.h"

#include <gtest/gtest.h>

#include "roomcast/viewer/report/host_time_fixture.h"

namespace roomcast::viewer {
namespace {

using namespace std::chrono_literals;

/// Captured at 0 on a room clock that is 5 s ahead, arrived at 30 ms, decoded in 4 ms.
client::SensorPicture picture_at(nanoseconds start) {
  client::SensorPicture picture;
  picture.capture_time = RoomTime(1h + 5s + start);
  picture.received = at(start + 30ms);
  picture.decoded = at(start + 34ms);
  return picture;
}

client::ClockEstimate clock_ahead() {
  return {at(0s), 5s, 0, 2ms};
}

TEST(LatencyBudget, the_stages_add_up_to_the_whole) {
  LatencyBudget budget;
  budget.shown(picture_at(0s), clock_ahead(), at(40ms), at(55ms));
  const auto stages = budget.median(at(60ms));
  ASSERT_TRUE(stages);
  EXPECT_DOUBLE_EQ(*stages->to_here_ms, 30);
  EXPECT_DOUBLE_EQ(stages->decoding_ms, 4);
  EXPECT_DOUBLE_EQ(stages->waiting_ms, 6);
  EXPECT_DOUBLE_EQ(stages->drawing_ms, 15);
  EXPECT_DOUBLE_EQ(*stages->total_ms, 55);
  EXPECT_DOUBLE_EQ(*stages->clock_error_ms, 2);
}

TEST(LatencyBudget, is_the_median_of_the_last_second) {
  LatencyBudget budget;
  budget.shown(picture_at(0s), clock_ahead(), at(500ms), at(900ms));
  for (const auto drawing : {10ms, 11ms, 300ms}) {
    budget.shown(picture_at(3s), clock_ahead(), at(3s + 40ms), at(3s + 40ms + drawing));
  }
  EXPECT_DOUBLE_EQ(budget.median(at(3400ms))->drawing_ms, 11);
}

TEST(LatencyBudget, leaves_unknown_stages_empty) {
  LatencyBudget budget;
  EXPECT_FALSE(budget.median(at(0s)));
  budget.shown(picture_at(0s), {}, at(40ms), at(55ms));
  EXPECT_FALSE(budget.median(at(60ms))->total_ms) << "without the hub's clock";
  EXPECT_FALSE(budget.median(at(5s))) << "nothing has come for seconds";
}

}  // namespace
}  // namespace roomcast::viewer
