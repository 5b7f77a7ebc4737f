// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/depth_grid_color.h"

#include <gtest/gtest.h>

namespace roomcast::codec {
namespace {

TEST(DepthGridColor, is_the_mean_of_a_pixels_quarters) {
  ColorImage fine(4, 2);
  fine.at(2, 0) = {10, 0, 255};
  fine.at(3, 0) = {20, 0, 255};
  fine.at(2, 1) = {30, 0, 255};
  fine.at(3, 1) = {42, 1, 255};
  const ColorImage mean = color_in_depth_grid(fine, 2, 1);
  EXPECT_EQ(mean.at(0, 0), (Rgb8{0, 0, 0}));
  EXPECT_EQ(mean.at(1, 0), (Rgb8{26, 0, 255}));
}

TEST(DepthGridColor, a_frame_that_has_it_stays_the_same) {
  const auto frame = std::make_shared<DecodedFrame>();
  frame->depth_mm = DepthImage(4, 2, 1000);
  EXPECT_EQ(with_color_in_depth_grid(frame), frame) << "without colour";
  frame->color = ColorImage(4, 2);
  EXPECT_EQ(with_color_in_depth_grid(frame), frame);
}

TEST(DepthGridColor, a_finer_frame_is_copied_with_all_it_has) {
  const auto frame = std::make_shared<DecodedFrame>();
  frame->depth_mm = DepthImage(4, 2, 1000);
  frame->color = ColorImage(8, 4, Rgb8{1, 2, 3});
  frame->color_seen = MaskImage(4, 2, 255);
  const auto coarse = with_color_in_depth_grid(frame);
  EXPECT_EQ(coarse->color, ColorImage(4, 2, Rgb8{1, 2, 3}));
  EXPECT_EQ(coarse->depth_mm, frame->depth_mm);
  EXPECT_EQ(coarse->color_seen, frame->color_seen);
}

}  // namespace
}  // namespace roomcast::codec
