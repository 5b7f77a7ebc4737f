// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/depth_factor.h"

#include <gtest/gtest.h>

namespace roomcast {
namespace {

TEST(DepthFactor, multiplies_and_rounds) {
  DepthImage depth_mm(2, 2);
  depth_mm.at(0, 0) = 1000;
  depth_mm.at(1, 0) = 2499;
  depth_mm.at(0, 1) = 64000;
  multiply_depth(depth_mm.view(), 1.04);
  EXPECT_EQ(depth_mm.at(0, 0), 1040);
  EXPECT_EQ(depth_mm.at(1, 0), 2599);   // 2598.96
  EXPECT_EQ(depth_mm.at(0, 1), 65535);  // the largest reading
  EXPECT_EQ(depth_mm.at(1, 1), 0);      // no reading
}

}  // namespace
}  // namespace roomcast
