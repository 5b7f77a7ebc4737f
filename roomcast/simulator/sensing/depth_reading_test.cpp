// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/depth_reading.h"

#include <gtest/gtest.h>

namespace roomcast::simulator {
namespace {

TEST(DepthReading, signal_falls_with_the_square_of_the_range_and_with_slant) {
  EXPECT_FLOAT_EQ(signal_strength(0.5F, 1.0F, 1.0F), 0.5F);
  EXPECT_FLOAT_EQ(signal_strength(0.5F, 1.0F, 2.0F), 0.125F);
  EXPECT_FLOAT_EQ(signal_strength(0.5F, 0.5F, 2.0F), 0.0625F);
}

TEST(DepthReading, a_pixel_on_one_surface_has_no_other) {
  const DepthReading floor{2.0F, 0.3F, 0.5F, 0.0F, {}};
  const OtherSurface other =
      other_surface(floor, {{{2.01F, 0.1F}, {2.01F, 0.1F}, {1.99F, 0.1F}, {1.99F, 0.1F}}});
  EXPECT_EQ(other.share, 0.0F);
}

TEST(DepthReading, the_other_surface_has_its_share_its_depth_and_its_light) {
  const DepthReading front{2.0F, 1.0F, 0.4F, 0.0F, {}};  // strength 0.1
  const OtherSurface other =
      other_surface(front, {{{2.0F, 0.1F}, {3.0F, 0.04F}, {3.2F, 0.04F}, {3.4F, 0.04F}}});
  EXPECT_FLOAT_EQ(other.share, 0.75F);
  EXPECT_NEAR(other.z_m, 3.2F, 1e-5F);
  EXPECT_NEAR(other.strength, 0.4F, 1e-5F);
}

TEST(DepthReading, a_black_surface_has_no_weight_and_the_void_is_no_surface) {
  const DepthReading front{2.0F, 1.0F, 0.4F, 0.0F, {}};
  const OtherSurface black =
      other_surface(front, {{{2.0F, 0.1F}, {2.0F, 0.1F}, {3.0F, 0.0F}, {0.0F, 0.0F}}});
  EXPECT_FLOAT_EQ(black.share, 0.25F);
  EXPECT_LT(black.strength, 1e-4F);
}

}  // namespace
}  // namespace roomcast::simulator
