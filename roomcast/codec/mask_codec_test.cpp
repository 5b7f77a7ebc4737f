// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/mask_codec.h"

#include <random>

#include <gtest/gtest.h>

#include "roomcast/codec/synthetic_color.h"

namespace roomcast::codec {
namespace {

std::vector<std::uint8_t> encoded(const MaskImage& mask, const DepthImage& depth) {
  std::vector<std::uint8_t> bytes;
  encode_mask(mask, depth, bytes);
  return bytes;
}

MaskImage decoded(std::span<const std::uint8_t> bytes, const DepthImage& depth) {
  MaskImage mask(depth.width(), depth.height(), 7);
  decode_mask(bytes, depth, mask.view());
  return mask;
}

void expect_round_trip(const MaskImage& mask, const DepthImage& depth) {
  MaskImage expected(mask.width(), mask.height());
  for (std::size_t i = 0; i < mask.view().pixel_count(); ++i) {
    expected.data()[i] = mask.data()[i] && depth.data()[i] ? 255 : 0;
  }
  EXPECT_EQ(decoded(encoded(mask, depth), depth), expected);
}

TEST(MaskCodec, gives_back_every_mask_where_there_is_depth) {
  std::mt19937 random(5);
  for (const auto& [width, height] : {std::pair{16, 16}, {17, 31}, {63, 20}, {4096, 16}}) {
    const SyntheticFrame frame = synthetic_frame(width, height, 1);
    expect_round_trip(frame.seen, frame.depth_mm);
    MaskImage noise(width, height);
    for (std::size_t i = 0; i < noise.view().pixel_count(); ++i) {
      noise.data()[i] = static_cast<std::uint8_t>(random() & random());
    }
    for (const NamedDepth& depth : synthetic_depths(width, height)) {
      expect_round_trip(noise, depth.depth_mm);
      expect_round_trip(MaskImage(width, height, 255), depth.depth_mm);
      expect_round_trip(MaskImage(width, height, 0), depth.depth_mm);
    }
  }
}

TEST(MaskCodec, a_mask_like_a_sensors_takes_far_less_than_a_bit_per_pixel) {
  const SyntheticFrame frame = synthetic_frame(320, 240, 1);
  EXPECT_LT(encoded(frame.seen, frame.depth_mm).size(), 320u * 240u / 8 / 20);
  EXPECT_LT(encoded(MaskImage(320, 240, 255), frame.depth_mm).size(), 20u);
}

TEST(MaskCodec, garbage_gives_some_mask_and_none_without_depth) {
  std::mt19937 random(6);
  const DepthImage depth = synthetic_room(40, 30, 1);
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<std::uint8_t> bytes(random() % 200);
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
    const MaskImage mask = decoded(bytes, depth);
    for (std::size_t i = 0; i < mask.view().pixel_count(); ++i) {
      ASSERT_TRUE(mask.data()[i] == 0 || (mask.data()[i] == 255 && depth.data()[i] != 0));
    }
  }
}

}  // namespace
}  // namespace roomcast::codec
