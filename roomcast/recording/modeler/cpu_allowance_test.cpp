// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/modeler/cpu_allowance.h"

#include <gtest/gtest.h>

namespace roomcast::recording {
namespace {

using namespace std::chrono_literals;

HostTime allowance_time(nanoseconds since_start) {
  return HostTime(1h + since_start);
}

TEST(CpuAllowance, work_follows_work_after_a_calm_time) {
  CpuAllowance allowance;
  allowance.spent(1s, allowance_time(0s));
  EXPECT_LE(allowance.next(), allowance_time(0s));
  allowance.spent(1s, allowance_time(1s));
  EXPECT_LE(allowance.next(), allowance_time(1s));
}

TEST(CpuAllowance, work_that_goes_on_takes_a_third_of_the_time) {
  CpuAllowance allowance;
  HostTime now = allowance_time(0s);
  nanoseconds worked{};
  while (now < allowance_time(300s)) {
    now = std::max(now, allowance.next()) + 2s;
    worked += 2s;
    allowance.spent(2s, now);
  }
  EXPECT_NEAR(std::chrono::duration<double>(worked).count(), 100, 10);
}

TEST(CpuAllowance, no_more_is_saved_than_allowed) {
  CpuAllowance allowance({.time_per_work = 3, .max_saved = 4s});
  allowance.spent(0s, allowance_time(0s));
  allowance.spent(5s, allowance_time(3600s));
  EXPECT_EQ(allowance.next(), allowance_time(3611s));
}

}  // namespace
}  // namespace roomcast::recording
