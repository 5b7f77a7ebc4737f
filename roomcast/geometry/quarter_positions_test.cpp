// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/quarter_positions.h"

#include <gtest/gtest.h>

namespace roomcast {
namespace {

constexpr int kQuarteredWidth = 4, kQuarteredHeight = 3;

/// A wall whose pixels are 3 colour pixels apart horizontally and 2 vertically.
class QuarterPositions : public testing::Test {
 protected:
  QuarterPositions() {
    for (int y = 0; y < kQuarteredHeight; ++y) {
      for (int x = 0; x < kQuarteredWidth; ++x) {
        u_.push_back(10 + 3 * static_cast<float>(x));
        v_.push_back(20 + 2 * static_cast<float>(y));
      }
    }
    z_m_.assign(u_.size(), 2.0F);
  }

  void find(int y) {
    find_quarters(
        {kQuarteredWidth, kQuarteredHeight, u_.data(), v_.data(), z_m_.data(), 1, 100, 100}, y,
        upper_, lower_);
  }

  std::vector<float> u_, v_, z_m_;
  QuarterRow upper_, lower_;
};

TEST_F(QuarterPositions, lie_a_quarter_of_a_step_beside_the_middle) {
  find(1);
  ASSERT_EQ(upper_.u.size(), 2U * kQuarteredWidth);
  EXPECT_FLOAT_EQ(upper_.u[2], 13 - 0.75F);
  EXPECT_FLOAT_EQ(upper_.u[3], 13 + 0.75F);
  EXPECT_FLOAT_EQ(upper_.v[3], 22 - 0.5F);
  EXPECT_FLOAT_EQ(lower_.v[3], 22 + 0.5F);
}

TEST_F(QuarterPositions, at_the_border_the_one_neighbour_decides) {
  find(0);
  EXPECT_FLOAT_EQ(upper_.u[0], 10 - 0.75F);
  EXPECT_FLOAT_EQ(lower_.v[7], 20 + 0.5F);
}

TEST_F(QuarterPositions, a_neighbour_on_another_surface_is_ignored) {
  z_m_[6] = 1.0F;  // right of the pixel; its projection is far off to the side
  u_[6] = 40;
  find(1);
  EXPECT_FLOAT_EQ(upper_.u[3], 13 + 0.75F);
}

TEST_F(QuarterPositions, a_pixel_alone_takes_the_usual_spacing) {
  z_m_.assign(z_m_.size(), 0.0F);
  z_m_[5] = 2.0F;
  find(1);
  EXPECT_FLOAT_EQ(upper_.u[3], 13.25F);
  EXPECT_FLOAT_EQ(lower_.v[3], 22.25F);
}

TEST_F(QuarterPositions, stay_inside_the_colour_picture) {
  u_[0] = 0;
  find(0);
  EXPECT_FLOAT_EQ(upper_.u[0], 0);
}

}  // namespace
}  // namespace roomcast
