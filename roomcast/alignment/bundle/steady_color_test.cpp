// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/bundle/steady_color.h"

#include <vector>

#include <gtest/gtest.h>

namespace roomcast::alignment {
namespace {

TEST(SteadyColorPicture, is_the_median_of_each_pixel_and_each_colour) {
  std::vector<ColorImage> pictures(3, ColorImage(2, 1));
  pictures[0].at(0, 0) = {10, 200, 30};
  pictures[1].at(0, 0) = {30, 100, 10};
  pictures[2].at(0, 0) = {20, 150, 20};
  pictures[0].at(1, 0) = {1, 2, 3};
  pictures[1].at(1, 0) = {1, 2, 3};
  pictures[2].at(1, 0) = {255, 255, 255};
  const ColorImage steady = steady_color(pictures);
  EXPECT_EQ(steady.at(0, 0), (Rgb8{20, 150, 20}));
  EXPECT_EQ(steady.at(1, 0), (Rgb8{1, 2, 3}));
}

TEST(SteadyColorPicture, of_an_even_number_is_the_upper_of_both_in_the_middle) {
  std::vector<ColorImage> pictures;
  for (const int level : {40, 10, 30, 20}) {
    const auto grey = static_cast<std::uint8_t>(level);
    pictures.emplace_back(1, 1, Rgb8{grey, grey, grey});
  }
  EXPECT_EQ(steady_color(pictures).at(0, 0), (Rgb8{30, 30, 30}));
}

TEST(SteadyColorPicture, of_one_is_itself) {
  ColorImage picture(3, 2, {7, 8, 9});
  picture.at(2, 1) = {1, 2, 3};
  EXPECT_EQ(steady_color({&picture, 1}), picture);
}

TEST(SteadyColorPicture, somebody_who_crosses_half_of_the_time_or_less_leaves_no_trace) {
  std::vector<ColorImage> pictures(9, ColorImage(4, 3, {120, 110, 100}));
  for (std::size_t i = 0; i < 4; ++i) pictures[2 * i] = ColorImage(4, 3, {5, 5, 5});
  EXPECT_EQ(steady_color(pictures), pictures[1]);
}

}  // namespace
}  // namespace roomcast::alignment
