// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/recorder/unix_clock.h"

#include <gtest/gtest.h>

namespace roomcast::recording {
namespace {

TEST(UnixClock, begins_with_the_time_of_day_and_goes_on_evenly) {
  const auto before = std::chrono::system_clock::now().time_since_epoch();
  const UnixClock clock;
  const HostTime host = SteadyClock().now();
  EXPECT_GE(clock.at(host), before);
  EXPECT_LT(clock.at(host) - before, std::chrono::minutes(1));
  EXPECT_EQ(clock.at(host + std::chrono::hours(1)) - clock.at(host), std::chrono::hours(1));
}

}  // namespace
}  // namespace roomcast::recording
