// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/color_drift.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::simulator {
namespace {

using std::chrono::milliseconds;

TEST(ColorDrift, none_is_exactly_one) {
  EXPECT_EQ(ColorDrift().gains(milliseconds(1234)), (std::array<float, 3>{1, 1, 1}));
}

TEST(ColorDrift, wanders_within_its_limits_and_smoothly) {
  const ColorDrift drift{0.1F, 0.05F, 2.0F, 7};
  float lowest = 2, highest = 0, widest_step = 0, before = drift.gains({})[1];
  for (int i = 1; i < 3000; ++i) {
    const auto gains = drift.gains(milliseconds(33 * i));
    EXPECT_NEAR(gains[1], 1, 0.1F + 1e-6F);
    EXPECT_NEAR(gains[0] / gains[1], 1, 0.05F + 1e-6F);
    lowest = std::min(lowest, gains[1]);
    highest = std::max(highest, gains[1]);
    widest_step = std::max(widest_step, std::abs(gains[1] - before));
    before = gains[1];
  }
  EXPECT_LT(lowest, 0.95F);
  EXPECT_GT(highest, 1.05F);
  EXPECT_LT(widest_step, 0.01F) << "from frame to frame";
}

TEST(ColorDrift, differs_from_unit_to_unit) {
  const ColorDrift one{0.1F, 0.05F, 2.0F, 7}, other{0.1F, 0.05F, 2.0F, 8};
  EXPECT_NE(one.gains(milliseconds(700)), other.gains(milliseconds(700)));
}

}  // namespace
}  // namespace roomcast::simulator
