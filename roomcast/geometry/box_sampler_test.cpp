// SPDX-License-Identifier: Apache-2.0
#include "roomcast/geometry/box_sampler.h"

#include <gtest/gtest.h>

namespace roomcast {
namespace {

Rgb8 sample_at(SampleRow sampler, const ColorImage& picture, float u, float v) {
  const std::uint8_t take = 255;
  Rgb8 color;
  sampler(picture, &u, &v, &take, 1, &color);
  return color;
}

ColorImage ramp(int width, int height) {
  ColorImage picture(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      picture.at(x, y) = {static_cast<std::uint8_t>(4 * x), static_cast<std::uint8_t>(5 * y),
                          static_cast<std::uint8_t>(2 * x + 2 * y)};
    }
  }
  return picture;
}

TEST(BoxSampler, gives_back_a_linear_ramp_at_any_position_and_size) {
  const ColorImage picture = ramp(60, 50);
  for (int size = 1; size <= kLargestBox; ++size) {
    const SampleRow sampler = box_sampler(size, 60, 50);
    for (const float u : {10.0F, 10.25F, 33.5F, 40.75F}) {
      for (const float v : {10.0F, 20.5F, 33.25F}) {
        const Rgb8 color = sample_at(sampler, picture, u, v);
        EXPECT_NEAR(color.r, 4 * u, 0.6) << size;
        EXPECT_NEAR(color.g, 5 * v, 0.6) << size;
        EXPECT_NEAR(color.b, 2 * u + 2 * v, 0.6) << size;
      }
    }
  }
}

TEST(BoxSampler, averages_exactly_the_square) {
  ColorImage picture(9, 9);
  picture.at(4, 4) = {255, 90, 9};
  const SampleRow sampler = box_sampler(3, 9, 9);
  EXPECT_EQ(sample_at(sampler, picture, 4, 4), (Rgb8{28, 10, 1}));
  EXPECT_EQ(sample_at(sampler, picture, 5, 3), (Rgb8{28, 10, 1}));
  EXPECT_EQ(sample_at(sampler, picture, 5.5F, 4), (Rgb8{14, 5, 1}));  // half of it is outside
  EXPECT_EQ(sample_at(sampler, picture, 6, 4), Rgb8{});
}

TEST(BoxSampler, white_stays_white) {
  const ColorImage picture(40, 40, {255, 255, 255});
  for (int size = 1; size <= kLargestBox; ++size) {
    EXPECT_EQ(sample_at(box_sampler(size, 40, 40), picture, 17.37F, 11.81F), (Rgb8{255, 255, 255}));
  }
}

TEST(BoxSampler, a_checkerboard_does_not_alias) {
  ColorImage picture(40, 40);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      if ((x + y) % 2 == 0) picture.at(x, y) = {255, 255, 255};
    }
  }
  const SampleRow sampler = box_sampler(3, 40, 40);
  for (float u = 5; u < 30; u += 0.37F) {
    EXPECT_NEAR(sample_at(sampler, picture, u, u).g, 127, 16);  // one ninth of half the range
  }
}

TEST(BoxSampler, squares_at_the_border_are_moved_inside) {
  const ColorImage picture = ramp(20, 20);
  const SampleRow bilinear = box_sampler(1, 20, 20);
  EXPECT_EQ(sample_at(bilinear, picture, -0.5F, -0.5F), picture.at(0, 0));
  EXPECT_EQ(sample_at(bilinear, picture, 19, 19), picture.at(19, 19));
  EXPECT_EQ(sample_at(bilinear, picture, 19.5F, 19.5F), picture.at(19, 19));
  EXPECT_EQ(sample_at(box_sampler(3, 20, 20), picture, 19.5F, 0), (Rgb8{72, 5, 38}));
}

TEST(BoxSampler, boxes_larger_than_the_picture_are_reduced) {
  const ColorImage picture(2, 2, {7, 8, 9});
  EXPECT_EQ(sample_at(box_sampler(100, 2, 2), picture, 0.5F, 0.5F), (Rgb8{7, 8, 9}));
}

TEST(BoxSampler, unselected_positions_are_black) {
  const ColorImage picture(20, 20, {7, 8, 9});
  const float at[] = {3, 4};
  const std::uint8_t take[] = {0, 255};
  Rgb8 color[] = {{1, 1, 1}, {1, 1, 1}};
  box_sampler(2, 20, 20)(picture, at, at, take, 2, color);
  EXPECT_EQ(color[0], Rgb8{});
  EXPECT_EQ(color[1], (Rgb8{7, 8, 9}));
}

}  // namespace
}  // namespace roomcast
