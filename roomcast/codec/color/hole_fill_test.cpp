// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/color/hole_fill.h"

#include <gtest/gtest.h>

namespace roomcast::codec {
namespace {

using Plane = Image<std::uint8_t>;

TEST(HoleFill, keeps_known_pixels_and_fills_the_rest_from_them) {
  for (const auto& [width, height] : {std::pair{1, 1}, {2, 3}, {16, 16}, {33, 17}}) {
    Plane plane(width, height, 3);
    MaskImage known(width, height);
    plane.at(width / 2, height / 2) = 90;
    known.at(width / 2, height / 2) = 255;
    HoleFill().fill(plane.view(), known);
    EXPECT_EQ(plane, Plane(width, height, 90)) << width;
  }
}

TEST(HoleFill, stays_within_the_range_of_known_pixels) {
  Plane plane(40, 30);
  MaskImage known(40, 30);
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x) {
      known.at(x, y) = x < 8 || x >= 32;
      plane.at(x, y) = x < 8 ? 50 : x >= 32 ? 200 : 0;
    }
  }
  HoleFill().fill(plane.view(), known);
  for (int x = 0; x < 40; ++x) {
    EXPECT_GE(plane.at(x, 15), 50);
    EXPECT_LE(plane.at(x, 15), 200);
  }
  EXPECT_LT(plane.at(9, 15), plane.at(30, 15));
}

TEST(HoleFill, leaves_a_plane_without_known_pixels) {
  Plane plane(20, 20, 77);
  HoleFill().fill(plane.view(), MaskImage(20, 20));
  EXPECT_EQ(plane, Plane(20, 20, 77));
}

TEST(HoleFill, forgets_the_call_before) {
  HoleFill fill;
  Plane first(20, 20, 10);
  fill.fill(first.view(), MaskImage(20, 20, 255));
  Plane second(9, 11, 5);
  MaskImage known(9, 11);
  second.at(0, 0) = 60;
  known.at(0, 0) = 1;
  fill.fill(second.view(), known);
  EXPECT_EQ(second, Plane(9, 11, 60));
}

}  // namespace
}  // namespace roomcast::codec
