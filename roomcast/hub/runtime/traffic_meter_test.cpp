// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/runtime/traffic_meter.h"

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

using namespace std::chrono_literals;

TEST(TrafficMeter, needs_two_samples_for_a_rate) {
  TrafficMeter<int> meter;
  meter.sample(1, 1000, HostTime(1h));
  EXPECT_EQ(meter.per_s(1), 0);
  meter.sample(1, 1500, HostTime(1h + 500ms));
  EXPECT_EQ(meter.per_s(1), 1000);
  EXPECT_EQ(meter.per_s(2), 0);
}

TEST(TrafficMeter, a_restarted_counter_has_no_growth) {
  Growth growth;
  growth.sample(1000, HostTime(1h));
  growth.sample(10, HostTime(1h + 1s));
  EXPECT_EQ(growth.per_s(), 0);
}

TEST(TrafficMeter, forgets_unsampled_counters) {
  TrafficMeter<int> meter;
  meter.sample(1, 0, HostTime(1h));
  meter.sample(1, 9, HostTime(1h + 1s));
  meter.forget_before(HostTime(1h + 2s));
  EXPECT_EQ(meter.per_s(1), 0);
}

}  // namespace
}  // namespace roomcast::hub
