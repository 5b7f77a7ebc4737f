// SPDX-License-Identifier: Apache-2.0
#include "bench/align/said_error.h"

#include <array>

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

TEST(SaidError, contains_both_sensors_and_the_scale_of_the_way_between_them) {
  alignment::SensorReport a, b;
  a.expected_error_mm = 30;
  b.expected_error_mm = 40;
  RigidTransform a_from_b;
  EXPECT_DOUBLE_EQ(said_of(a, b, a_from_b, 0), 50);
  a_from_b.translation_m = {0, 0, 3.5};  // the point is 6 m away
  EXPECT_NEAR(said_of(a, b, a_from_b, 0.02), 130, 1e-9);
}

TEST(SaidError, counts_those_within_twice) {
  EXPECT_EQ(share_within_twice(std::array{0.5, 2.0, 2.1, 9.0}), 0.5);
  EXPECT_EQ(share_within_twice({}), 0);
}

}  // namespace
}  // namespace roomcast::bench
