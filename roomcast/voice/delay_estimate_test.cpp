// SPDX-License-Identifier: Apache-2.0
#include "roomcast/voice/delay_estimate.h"

#include <gtest/gtest.h>

namespace roomcast::voice {
namespace {

using namespace std::chrono_literals;

TEST(DelayEstimate, clocks_may_differ_by_any_time) {
  DelayEstimate delay;
  for (int n = 0; n < 500; ++n) delay.arrived(1h + n * 20ms, n * 20ms + 3ms);
  EXPECT_NEAR(delay.shortest_ms(), -3'599'997, 0.01);
  EXPECT_EQ(delay.target_ms(), DelayEstimate::kMin_ms);
}

TEST(DelayEstimate, waits_as_long_as_most_packets_need) {
  DelayEstimate delay;
  for (int n = 0; n < 1000; ++n) delay.arrived(n * 20ms, n * 20ms + (n % 10) * 10ms);
  EXPECT_NEAR(delay.target_ms(), 100, 5);
}

TEST(DelayEstimate, one_late_packet_is_forgotten_and_never_costs_more_than_the_most) {
  DelayEstimate delay;
  for (int n = 0; n < 100; ++n) delay.arrived(n * 20ms, n * 20ms);
  delay.arrived(2s, 5s);
  EXPECT_EQ(delay.target_ms(), DelayEstimate::kMax_ms);
  for (int n = 101; n < 1500; ++n) delay.arrived(n * 20ms, n * 20ms);
  EXPECT_EQ(delay.target_ms(), DelayEstimate::kMin_ms);
}

}  // namespace
}  // namespace roomcast::voice
