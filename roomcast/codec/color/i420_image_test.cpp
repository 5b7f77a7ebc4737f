// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/color/i420_image.h"

#include <cstdlib>

#include <gtest/gtest.h>

namespace roomcast::codec {
namespace {

I420Image converted(const ColorImage& color, const MaskImage& seen) {
  I420Image image;
  image.resize(color.width(), color.height());
  convert_seen(color, seen, image);
  return image;
}

I420Image of_one_color(Rgb8 color) {
  return converted(ColorImage(2, 2, color), MaskImage(2, 2, 255));
}

// Colour bars of 100 %, ITU-R BT.709, 8 bit: the values in tables of test signals.
TEST(I420Image, gives_the_values_of_bt_709) {
  struct Bar {
    Rgb8 rgb;
    int y, cb, cr;
  };
  for (const Bar& bar : {Bar{{255, 255, 255}, 235, 128, 128}, Bar{{0, 0, 0}, 16, 128, 128},
                         Bar{{255, 0, 0}, 63, 102, 240}, Bar{{0, 255, 0}, 173, 42, 26},
                         Bar{{0, 0, 255}, 32, 240, 118}, Bar{{255, 255, 0}, 219, 16, 138}}) {
    const I420Image image = of_one_color(bar.rgb);
    EXPECT_EQ(image.y.at(1, 1), bar.y);
    EXPECT_EQ(image.cb.at(0, 0), bar.cb);
    EXPECT_EQ(image.cr.at(0, 0), bar.cr);
  }
}

TEST(I420Image, gives_back_colours_to_a_rounding_of_each_plane) {
  constexpr int kMaxError = 3;  // rounding by 1/2: Y gives 0.6, Cb 1.1 in blue; both, and rounding
  for (int i = 0; i < 4096; ++i) {
    const Rgb8 color{static_cast<std::uint8_t>((i & 15) * 17),
                     static_cast<std::uint8_t>((i >> 4 & 15) * 17),
                     static_cast<std::uint8_t>((i >> 8) * 17)};
    const I420Image image = of_one_color(color);
    ColorImage back(2, 2);
    convert_to_rgb({image.y, image.cb, image.cr}, back.view());
    EXPECT_LE(std::abs(back.at(0, 0).r - color.r), kMaxError);
    EXPECT_LE(std::abs(back.at(0, 0).g - color.g), kMaxError);
    EXPECT_LE(std::abs(back.at(0, 0).b - color.b), kMaxError);
  }
}

TEST(I420Image, takes_seen_pixels_only_and_keeps_the_rest) {
  ColorImage color(3, 3);
  MaskImage seen(3, 3);
  color.at(0, 0) = {255, 0, 0};
  seen.at(0, 0) = 255;
  color.at(1, 1) = {0, 0, 255};  // not seen
  color.at(2, 2) = {0, 255, 0};  // alone in its chroma block at the odd edge
  seen.at(2, 2) = 1;
  const I420Image image = converted(color, seen);
  EXPECT_EQ(image.y.at(0, 0), 63);
  EXPECT_EQ(image.y.at(1, 1), 16) << "as it was";
  EXPECT_EQ(image.cr.at(0, 0), 240) << "the unseen blue does not count";
  EXPECT_EQ(image.cb.at(1, 1), 42);
  EXPECT_EQ(image.cb.at(1, 0), 128) << "as it was";
}

}  // namespace
}  // namespace roomcast::codec
