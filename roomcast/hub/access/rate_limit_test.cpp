// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/access/rate_limit.h"

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

using namespace std::chrono_literals;

TEST(RateLimit, a_steady_stream_below_the_rate_passes) {
  RateLimit limit(10, 5);
  for (int i = 0; i < 1000; ++i) EXPECT_TRUE(limit.take(1, HostTime(1h + i * 100ms)));
}

TEST(RateLimit, a_burst_passes_and_more_does_not) {
  RateLimit limit(10, 5);
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(limit.take(1, HostTime(1h)));
  EXPECT_FALSE(limit.take(1, HostTime(1h)));
}

TEST(RateLimit, twice_the_rate_is_noticed_within_a_burst) {
  RateLimit limit(10, 5);
  int passed = 0;
  while (passed < 100 && limit.take(1, HostTime(1h + passed * 50ms))) ++passed;
  EXPECT_GE(passed, 5);
  EXPECT_LT(passed, 15);
}

}  // namespace
}  // namespace roomcast::hub
