// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/runtime/traffic_meter.h"

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

using namespace std::chrono_literals;

TEST(TrafficMeter, one_look_says_nothing_and_two_say_how_fast) {
  TrafficMeter<int> meter;
  meter.look(1, 1000, HostTime(1h));
  EXPECT_EQ(meter.per_s(1), 0);
  meter.look(1, 1500, HostTime(1h + 500ms));
  EXPECT_EQ(meter.per_s(1), 1000);
  EXPECT_EQ(meter.per_s(2), 0);
}

TEST(TrafficMeter, a_counter_that_started_again_has_not_grown) {
  Growth growth;
  growth.look(1000, HostTime(1h));
  growth.look(10, HostTime(1h + 1s));
  EXPECT_EQ(growth.per_s(), 0);
}

TEST(TrafficMeter, forgets_what_is_no_longer_looked_at) {
  TrafficMeter<int> meter;
  meter.look(1, 0, HostTime(1h));
  meter.look(1, 9, HostTime(1h + 1s));
  meter.forget_before(HostTime(1h + 2s));
  EXPECT_EQ(meter.per_s(1), 0);
}

}  // namespace
}  // namespace roomcast::hub
