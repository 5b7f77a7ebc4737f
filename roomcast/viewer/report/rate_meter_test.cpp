// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/report/rate_meter.h"

#include <gtest/gtest.h>

#include "roomcast/viewer/report/host_time_fixture.h"

namespace roomcast::viewer {
namespace {

using namespace std::chrono_literals;

TEST(RateMeter, is_the_current_growth_per_second) {
  RateMeter meter;
  EXPECT_EQ(meter.per_second(), 0);
  std::uint64_t total = 100;
  for (int i = 0; i <= 100; ++i) meter.count(at(i * 100ms), total += i < 50 ? 1 : 3);
  EXPECT_NEAR(meter.per_second(), 30, 1e-9) << "growth before the last 2 s does not count";
}

TEST(RateMeter, many_counts_in_a_moment_are_one) {
  RateMeter meter;
  for (int i = 0; i <= 2000; ++i) meter.count(at(i * 1ms), static_cast<std::uint64_t>(i));
  EXPECT_NEAR(meter.per_second(), 1000, 1);
}

TEST(RateMeter, a_count_that_begins_anew_is_no_negative_rate) {
  RateMeter meter;
  meter.count(at(0s), 1000);
  meter.count(at(1s), 5);
  EXPECT_EQ(meter.per_second(), 0);
  meter.count(at(2s), 15);
  EXPECT_NEAR(meter.per_second(), 10, 1e-9);
}

}  // namespace
}  // namespace roomcast::viewer
