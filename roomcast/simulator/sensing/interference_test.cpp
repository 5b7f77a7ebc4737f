// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/interference.h"

#include <chrono>
#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::simulator {
namespace {

using std::chrono::milliseconds;
using std::chrono::minutes;

TEST(Interference, is_off_by_default) {
  const Interference none(0.0, 7);
  for (nanoseconds t{}; t < minutes(5); t += milliseconds(100)) EXPECT_FALSE(none.at(t));
}

TEST(Interference, bursts_have_the_requested_rate_and_length) {
  constexpr int kMinutes = 200;
  constexpr double kPerMinute = 6.0;
  const Interference bursts(kPerMinute, 7);
  double count = 0, on_s = 0;
  std::uint32_t last_key = 0;
  for (nanoseconds t{}; t < minutes(kMinutes); t += milliseconds(20)) {
    const auto burst = bursts.at(t);
    if (!burst) continue;
    on_s += 0.02;
    EXPECT_GT(burst->strength, 0.0F);
    EXPECT_LE(burst->strength, 1.0F);
    EXPECT_LE(std::abs(burst->ripple_mm(100, 50)), 8.0F);
    if (burst->key != last_key) ++count;
    last_key = burst->key;
  }
  const double expected = kPerMinute * kMinutes;
  EXPECT_NEAR(count, expected, 4.0 * std::sqrt(expected));
  EXPECT_NEAR(on_s / count, 0.45, 0.05);
}

TEST(Interference, is_a_function_of_time_for_each_sensor) {
  const Interference one(30.0, 1), same(30.0, 1), other(30.0, 2);
  int differing = 0;
  for (nanoseconds t = -minutes(1); t < minutes(1); t += milliseconds(50)) {
    ASSERT_EQ(one.at(t).has_value(), same.at(t).has_value());
    differing += one.at(t).has_value() != other.at(t).has_value();
  }
  EXPECT_GT(differing, 100);
}

}  // namespace
}  // namespace roomcast::simulator
