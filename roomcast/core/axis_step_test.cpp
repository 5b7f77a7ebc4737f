// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/axis_step.h"

#include <gtest/gtest.h>

namespace roomcast {
namespace {

TEST(AxisStep, is_a_round_number_and_few_enough_reach) {
  EXPECT_DOUBLE_EQ(axis_step(4, 4), 1);
  EXPECT_DOUBLE_EQ(axis_step(4.1, 4), 2);
  EXPECT_DOUBLE_EQ(axis_step(9, 4), 5);
  EXPECT_DOUBLE_EQ(axis_step(21, 4), 10);
  EXPECT_DOUBLE_EQ(axis_step(0.07, 5), 0.02);
}

}  // namespace
}  // namespace roomcast
