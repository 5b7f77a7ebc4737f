// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/ros_picture.h"

#include <cstring>

#include <gtest/gtest.h>

#include "roomcast/io/png_codec.h"

namespace roomcast::recording {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// The settings before the picture: format, and the two numbers of inverse depth.
Bytes depth_head(float a, float b) {
  Bytes bytes(12);
  std::memcpy(bytes.data() + 4, &a, 4);
  std::memcpy(bytes.data() + 8, &b, 4);
  return bytes;
}

TEST(RosPicture, compressed_depth_of_integers_is_exact) {
  DepthImage original(7, 5);
  for (int i = 0; i < 35; ++i) original.data()[i] = static_cast<std::uint16_t>(1000 + 37 * i);
  Bytes bytes = depth_head(0, 0);
  ASSERT_EQ(io::encode_depth_png(original, bytes), "");
  DepthImage depth;
  RosPictureDecoder decoder;
  ros::CompressedImageMessage message{{}, "16UC1; compressedDepth png", bytes};
  ASSERT_TRUE(decoder.depth(message, 7, 5, depth).ok());
  EXPECT_EQ(depth, original);
  EXPECT_FALSE(decoder.depth(message, 8, 5, depth).ok());
  message.data = message.data.first(11);
  EXPECT_FALSE(decoder.depth(message, 7, 5, depth).ok());
}

TEST(RosPicture, compressed_depth_of_floats_is_inverse) {
  Bytes bytes = depth_head(2000, -50);
  DepthImage stored(2, 1);
  stored.at(0, 0) = 950;  // 2000 / (950 + 50) m
  ASSERT_EQ(io::encode_depth_png(stored, bytes), "");
  DepthImage depth;
  RosPictureDecoder decoder;
  ASSERT_TRUE(decoder.depth({{}, "32FC1; compressedDepth png", bytes}, 2, 1, depth).ok());
  EXPECT_EQ(depth.at(0, 0), 2000);
  EXPECT_EQ(depth.at(1, 0), 0);
}

/// Words of eight numbers of three bits: 1 zero, 2 values, +3 (as 6), -1 (as 1), 1 zero, no values.
TEST(RosPicture, rvl_is_read) {
  const Bytes bytes = {0x00, 0x10, 0x61, 0x12};
  DepthImage depth(4, 1, 99);
  ASSERT_TRUE(decode_rvl(bytes, depth));
  EXPECT_EQ(depth.at(0, 0), 0);
  EXPECT_EQ(depth.at(1, 0), 3);
  EXPECT_EQ(depth.at(2, 0), 2);
  EXPECT_EQ(depth.at(3, 0), 0);
  EXPECT_FALSE(decode_rvl({}, depth));
  EXPECT_FALSE(decode_rvl(Bytes(8, 0), depth));      // says nothing
  EXPECT_FALSE(decode_rvl(Bytes(64, 0xFF), depth));  // a number without an end
}

TEST(RosPicture, encodings_tell_depth_from_colour) {
  EXPECT_EQ(kind_of_encoding("16UC1", "/camera/depth/image_raw"), RosPictureKind::kDepth);
  EXPECT_EQ(kind_of_encoding("mono16", "/camera/depth/image_raw"), RosPictureKind::kDepth);
  EXPECT_EQ(kind_of_encoding("mono16", "/camera/thermal/image_raw"), RosPictureKind::kOther);
  EXPECT_EQ(kind_of_encoding("mono8", "/camera/infra1/image_raw"), RosPictureKind::kOther);
  EXPECT_EQ(kind_of_encoding("bgr8", "/a"), RosPictureKind::kColor);
  EXPECT_EQ(kind_of_encoding("bayer_rggb8", "/a"), RosPictureKind::kOther);
  EXPECT_EQ(kind_of_compressed("rgb8; jpeg compressed bgr8"), RosPictureKind::kColor);
  EXPECT_EQ(kind_of_compressed("16UC1; compressedDepth rvl"), RosPictureKind::kDepth);
  EXPECT_EQ(kind_of_compressed("h264"), RosPictureKind::kOther);
}

}  // namespace
}  // namespace roomcast::recording
