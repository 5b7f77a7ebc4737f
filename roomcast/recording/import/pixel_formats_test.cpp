// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/pixel_formats.h"

#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include "roomcast/io/png_codec.h"

namespace roomcast::recording {
namespace {

using Bytes = std::vector<std::uint8_t>;

ColorImage color_of(PixelFormat format, int width, int height, const Bytes& bytes,
                    std::size_t row_bytes = 0) {
  PictureDecoder decoder;
  ColorImage color;
  const Status status = decoder.color({format, width, height, row_bytes, bytes}, color);
  EXPECT_TRUE(status.ok()) << (status.ok() ? "" : status.error().message);
  return color;
}

TEST(PictureDecoder, reads_colour_in_every_order) {
  const Rgb8 red{200, 10, 20};
  EXPECT_EQ(color_of(PixelFormat::kRgb8, 1, 1, {200, 10, 20}).at(0, 0), red);
  EXPECT_EQ(color_of(PixelFormat::kBgr8, 1, 1, {20, 10, 200}).at(0, 0), red);
  EXPECT_EQ(color_of(PixelFormat::kRgba8, 1, 1, {200, 10, 20, 9}).at(0, 0), red);
  EXPECT_EQ(color_of(PixelFormat::kBgra8, 1, 1, {20, 10, 200, 9}).at(0, 0), red);
  EXPECT_EQ(color_of(PixelFormat::kMono8, 1, 1, {77}).at(0, 0), (Rgb8{77, 77, 77}));
}

/// Values of BT.601: white, black, and saturated red (81, 90, 240).
TEST(PictureDecoder, reads_yuv_by_bt601) {
  const auto expect = [](const Rgb8& seen, int r, int g, int b) {
    EXPECT_NEAR(seen.r, r, 1);
    EXPECT_NEAR(seen.g, g, 1);
    EXPECT_NEAR(seen.b, b, 1);
  };
  const ColorImage yuy2 = color_of(PixelFormat::kYuy2, 4, 1, {235, 128, 16, 128, 81, 90, 81, 240});
  expect(yuy2.at(0, 0), 255, 255, 255);
  expect(yuy2.at(1, 0), 0, 0, 0);
  expect(yuy2.at(2, 0), 255, 0, 0);
  const ColorImage uyvy = color_of(PixelFormat::kUyvy, 2, 1, {90, 81, 240, 235});
  expect(uyvy.at(0, 0), 255, 0, 0);
  const ColorImage nv12 = color_of(PixelFormat::kNv12, 2, 2, {81, 81, 81, 81, 90, 240});
  expect(nv12.at(1, 1), 255, 0, 0);
}

TEST(PictureDecoder, rows_may_have_gaps) {
  const ColorImage color = color_of(PixelFormat::kMono8, 2, 2, {1, 2, 99, 3, 4}, 3);
  EXPECT_EQ(color.at(0, 1).r, 3);
  EXPECT_EQ(color.at(1, 1).r, 4);
}

TEST(PictureDecoder, reads_depth_of_both_byte_orders_floats_and_png) {
  PictureDecoder decoder;
  DepthImage depth;
  const Bytes little = {0x34, 0x12}, big = {0x12, 0x34};
  ASSERT_TRUE(decoder.depth({PixelFormat::kDepth16Little, 1, 1, 0, little}, depth).ok());
  EXPECT_EQ(depth.at(0, 0), 0x1234);
  ASSERT_TRUE(decoder.depth({PixelFormat::kDepth16Big, 1, 1, 0, big}, depth).ok());
  EXPECT_EQ(depth.at(0, 0), 0x1234);
  const float metres[] = {1.2344F, std::numeric_limits<float>::quiet_NaN(), -1, 70,
                          std::numeric_limits<float>::infinity()};
  Bytes floats(sizeof(metres));
  std::memcpy(floats.data(), metres, sizeof(metres));
  ASSERT_TRUE(decoder.depth({PixelFormat::kDepthFloat, 5, 1, 0, floats}, depth).ok());
  EXPECT_EQ(depth.at(0, 0), 1234);
  for (int x = 1; x < 5; ++x) EXPECT_EQ(depth.at(x, 0), 0) << x;
  Bytes png;
  ASSERT_EQ(io::encode_depth_png(DepthImage(3, 2, 777), png), "");
  ASSERT_TRUE(decoder.depth({PixelFormat::kPng, 3, 2, 0, png}, depth).ok());
  EXPECT_EQ(depth, DepthImage(3, 2, 777));
}

TEST(PictureDecoder, missing_bytes_and_impossible_sizes_are_refused) {
  PictureDecoder decoder;
  DepthImage depth;
  ColorImage color;
  const Bytes bytes(11);
  for (const PixelFormat format : {PixelFormat::kRgb8, PixelFormat::kYuy2, PixelFormat::kNv12}) {
    EXPECT_EQ(decoder.color({format, 4, 2, 0, bytes}, color).error().code, ErrorCode::kMalformed);
  }
  EXPECT_FALSE(decoder.color({PixelFormat::kRgb8, 2, 1, 5, bytes}, color).ok());
  EXPECT_FALSE(decoder.color({PixelFormat::kNv12, 3, 2, 0, bytes}, color).ok());
  EXPECT_FALSE(decoder.color({PixelFormat::kJpeg, 3, 2, 0, bytes}, color).ok());
  EXPECT_FALSE(decoder.color({PixelFormat::kPng, 3, 2, 0, {}}, color).ok());
  EXPECT_EQ(decoder.color({PixelFormat::kRgb8, 0, 5, 0, bytes}, color).error().code,
            ErrorCode::kTooLarge);
  EXPECT_EQ(decoder.depth({PixelFormat::kDepth16Big, 100'000, 1, 0, bytes}, depth).error().code,
            ErrorCode::kTooLarge);
  EXPECT_EQ(decoder.depth({PixelFormat::kRgb8, 1, 1, 0, bytes}, depth).error().code,
            ErrorCode::kUnsupported);
  EXPECT_EQ(decoder.color({PixelFormat::kDepth16Big, 1, 1, 0, bytes}, color).error().code,
            ErrorCode::kUnsupported);
}

}  // namespace
}  // namespace roomcast::recording
