// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/stereo_shadow.h"

#include <gtest/gtest.h>

namespace roomcast::simulator {
namespace {

TEST(StereoShadow, lies_left_of_near_things_as_wide_as_the_disparities_differ) {
  DepthImage clean(200, 3, 4000);  // disparity 424 * 50 / 4000 = 5.3 px
  for (int y = 0; y < 3; ++y) {
    for (int x = 100; x < 120; ++x) clean.at(x, y) = 1000;  // 21.2 px
  }
  DepthImage depth = clean;
  take_stereo_shadow(clean, 424.0F, 50.0F, depth.view());
  for (int x = 20; x < 200; ++x) {
    const bool hidden = x >= 85 && x < 100;  // shadow of 15.9 px next to the object
    EXPECT_EQ(depth.at(x, 1) == 0, hidden) << x;
  }
}

TEST(StereoShadow, a_slanted_wall_throws_none_and_the_left_edge_is_not_seen_by_both) {
  DepthImage clean(200, 1);
  for (int x = 0; x < 200; ++x) clean.at(x, 0) = static_cast<std::uint16_t>(2000 + 5 * x);
  DepthImage depth = clean;
  take_stereo_shadow(clean, 424.0F, 50.0F, depth.view());
  EXPECT_EQ(depth.at(0, 0), 0);
  for (int x = 12; x < 200; ++x) EXPECT_EQ(depth.at(x, 0), clean.at(x, 0));
}

}  // namespace
}  // namespace roomcast::simulator
