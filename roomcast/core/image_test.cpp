// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/image.h"

#include <gtest/gtest.h>

namespace roomcast {
namespace {

TEST(Image, pixels_are_row_major_from_the_top_left) {
  DepthImage image(3, 2);
  image.at(2, 1) = 7;
  EXPECT_EQ(image.data()[5], 7);
  EXPECT_EQ(image.view().row(1)[2], 7);
}

TEST(Image, a_view_of_a_part_keeps_the_stride_of_the_whole) {
  DepthImage image(4, 4);
  image.at(2, 3) = 9;
  const DepthView part{image.data() + 4 + 1, 2, 3, 4};
  EXPECT_EQ(part.at(1, 2), 9);
  EXPECT_FALSE(part.contiguous());
}

TEST(Image, resizing_to_the_same_size_does_not_allocate) {
  ColorImage image(8, 8);
  const Rgb8* before = image.data();
  image.resize(8, 8);
  EXPECT_EQ(image.data(), before);
}

}  // namespace
}  // namespace roomcast
