// SPDX-License-Identifier: Apache-2.0
#include "bench/line/line_rate.h"

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

using namespace std::chrono_literals;

TEST(LineRate, an_even_line_has_one_rate) {
  LineRate rate;
  for (int i = 0; i <= 200; ++i)
    rate.add(LineRate::Time(i * 10ms), static_cast<std::uint64_t>(i) * 1'250);
  EXPECT_NEAR(rate.mean(), 1, 1e-9);
  EXPECT_NEAR(rate.over(200ms).lowest.value(), 1, 1e-9);
  EXPECT_NEAR(rate.over(200ms).highest, 1, 1e-9);
}

TEST(LineRate, a_burst_shows_in_the_short_window_only) {
  LineRate rate;
  std::uint64_t bytes = 0;
  for (int i = 0; i <= 300; ++i) {
    rate.add(LineRate::Time(i * 10ms), bytes);
    bytes += i % 100 < 20 ? 2'500 : 937;
  }
  EXPECT_GT(rate.over(200ms).highest, 1.9);
  EXPECT_LT(rate.over(1s).highest, 1.05);
  EXPECT_LT(rate.over(200ms).lowest.value(), 0.8);
}

TEST(LineRate, knows_when_a_rate_was_reached) {
  LineRate rate;
  std::uint64_t bytes = 0;
  for (int i = 0; i <= 300; ++i) {
    rate.add(LineRate::Time(i * 10ms), bytes);
    bytes += i < 100 ? 1'250 : 5'000;
  }
  EXPECT_EQ(rate.time_until(3.9, 200ms), 1'200ms);
  EXPECT_FALSE(rate.time_until(5, 200ms));
}

TEST(LineRate, a_window_whose_senders_have_nothing_more_to_send_is_not_too_slow) {
  LineRate rate;
  std::uint64_t bytes = 0;
  for (int i = 0; i <= 300; ++i) {
    rate.add(LineRate::Time(i * 10ms), bytes, i < 150);
    bytes += i < 150 ? 1'250 : 100;
  }
  EXPECT_NEAR(rate.over(200ms).lowest.value(), 1, 1e-9);
  EXPECT_NEAR(rate.over(200ms).without_more, 151.0 / 281, 1e-9);
  EXPECT_NEAR(rate.over(200ms).mean_of_others.value(), 1, 1e-9);
}

TEST(LineRate, without_readings_there_is_no_rate) {
  const LineRate rate;
  EXPECT_EQ(rate.mean(), 0);
  EXPECT_EQ(rate.over(1s).highest, 0);
  EXPECT_FALSE(rate.over(1s).lowest);
  EXPECT_FALSE(rate.over(1s).mean_of_others);
}

}  // namespace
}  // namespace roomcast::bench
