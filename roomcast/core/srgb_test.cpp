// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/srgb.h"

#include <cmath>

#include <gtest/gtest.h>

namespace roomcast {
namespace {

TEST(Srgb, grey_reflects_a_fifth_of_the_light) {
  EXPECT_EQ(linear_from_level(0), 0);
  EXPECT_NEAR(linear_from_level(128), 0.2159, 1e-4);
  EXPECT_NEAR(linear_from_level(255), 1, 1e-6);
}

TEST(Srgb, every_level_comes_back) {
  const auto linear = linear_levels();
  for (int level = 0; level < 256; ++level)
    EXPECT_EQ(std::lround(level_from_linear(linear[static_cast<std::size_t>(level)])), level);
}

}  // namespace
}  // namespace roomcast
