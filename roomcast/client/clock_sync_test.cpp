// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/clock_sync.h"

#include <random>

#include <gtest/gtest.h>

namespace roomcast {
namespace {

using namespace std::chrono_literals;

HostTime host(nanoseconds t) {
  return HostTime(t);
}
RoomTime room(nanoseconds t) {
  return RoomTime(t);
}

TEST(ClockSync, knows_nothing_before_the_first_exchange) {
  EXPECT_FALSE(ClockSync().estimate().has_value());
}

TEST(ClockSync, an_even_way_there_and_back_gives_the_offset) {
  ClockSync sync;
  sync.add(host(100ms), room(5s + 105ms), host(110ms));
  const auto estimate = sync.estimate();
  ASSERT_TRUE(estimate);
  EXPECT_EQ(estimate->room_minus_host, 5s);
  EXPECT_EQ(estimate->error, 5ms);
  EXPECT_EQ(estimate->room_time(host(1s)), room(6s));
}

TEST(ClockSync, the_shortest_round_trip_is_believed) {
  ClockSync sync;
  sync.add(host(0ms), room(1s + 90ms), host(100ms));  // 40 ms off
  sync.add(host(200ms), room(1s + 201ms), host(202ms));
  sync.add(host(300ms), room(1s + 310ms), host(400ms));
  EXPECT_EQ(sync.estimate()->room_minus_host, 1s);
  EXPECT_EQ(sync.estimate()->error, 1ms);
}

TEST(ClockSync, old_exchanges_are_forgotten) {
  ClockSync sync;
  sync.add(host(0ms), room(1s), host(0ms));
  for (std::size_t i = 0; i < ClockSync::kWindow; ++i)
    sync.add(host(0ms), room(2s + 5ms), host(10ms));
  EXPECT_EQ(sync.estimate()->room_minus_host, 2s);
}

TEST(ClockSync, an_answer_before_its_question_is_ignored) {
  ClockSync sync;
  sync.add(host(10ms), room(1s), host(5ms));
  EXPECT_FALSE(sync.estimate().has_value());
}

TEST(ClockSync, the_error_bound_holds_on_a_network_that_is_slow_one_way) {
  std::mt19937 random(1);
  std::exponential_distribution<double> queueing(1 / 20e6);  // 20 ms on average, each way
  ClockSync sync;
  const nanoseconds truth = 1234ms;
  for (int i = 0; i < 100; ++i) {
    const nanoseconds sent = i * 500ms;
    const nanoseconds there(static_cast<std::int64_t>(2e6 + queueing(random)));
    const nanoseconds back(static_cast<std::int64_t>(2e6 + queueing(random) / 4));
    sync.add(host(sent), room(sent + there + truth), host(sent + there + back));
    const auto estimate = sync.estimate();
    EXPECT_LE(std::chrono::abs(estimate->room_minus_host - truth), estimate->error);
  }
  EXPECT_LT(sync.estimate()->error, 10ms);
}

}  // namespace
}  // namespace roomcast
