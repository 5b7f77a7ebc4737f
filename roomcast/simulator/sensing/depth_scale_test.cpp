// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/depth_scale.h"

#include <gtest/gtest.h>

namespace roomcast::simulator {
namespace {

TEST(DepthScale, true_depth_is_the_scale_times_the_reading) {
  for (const double scale : {0.95, 0.98, 1.0, 1.05}) {
    DepthImage depth_mm(3, 1);
    depth_mm.at(0, 0) = 1000;
    depth_mm.at(1, 0) = 4321;
    depth_mm.at(2, 0) = 0;
    apply_depth_scale(scale, depth_mm.view());
    EXPECT_NEAR(scale * depth_mm.at(0, 0), 1000, 0.6);
    EXPECT_NEAR(scale * depth_mm.at(1, 0), 4321, 0.6);
    EXPECT_EQ(depth_mm.at(2, 0), 0);
  }
}

TEST(DepthScale, readings_stay_readings) {
  DepthImage depth_mm(2, 1);
  depth_mm.at(0, 0) = 65535;
  depth_mm.at(1, 0) = 1;
  apply_depth_scale(0.95, depth_mm.view());
  EXPECT_EQ(depth_mm.at(0, 0), 65535);
  EXPECT_EQ(depth_mm.at(1, 0), 1);
}

}  // namespace
}  // namespace roomcast::simulator
