// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/mask/intra_mask.h"

#include <random>

#include <gtest/gtest.h>

#include "roomcast/codec/testing/synthetic_color.h"

namespace roomcast::codec {
namespace {

std::vector<std::uint8_t> encoded_mask(const MaskImage& mask, const DepthImage& depth) {
  std::vector<std::uint8_t> bytes;
  MaskImage known(mask.width(), mask.height());
  encode_intra_mask(mask, depth, known.view(), bytes);
  return bytes;
}

MaskImage decoded(std::span<const std::uint8_t> bytes, const DepthImage& depth) {
  MaskImage known(depth.width(), depth.height(), 7);
  decode_intra_mask(bytes, depth, known.view());
  return known;
}

void expect_mask_round_trip(const MaskImage& mask, const DepthImage& depth) {
  std::vector<std::uint8_t> bytes;
  MaskImage known(mask.width(), mask.height());
  encode_intra_mask(mask, depth, known.view(), bytes);
  for (std::size_t i = 0; i < mask.view().pixel_count(); ++i) {
    const bool reading = depth.data()[i] != 0;
    ASSERT_TRUE(!reading || (known.data()[i] != 0) == (mask.data()[i] != 0));
  }
  EXPECT_EQ(decoded(bytes, depth), known);
}

TEST(IntraMask, gives_back_every_mask_where_there_is_depth) {
  std::mt19937 random(5);
  for (const auto& [width, height] : {std::pair{16, 16}, {17, 31}, {63, 20}, {4096, 16}}) {
    const SyntheticFrame frame = synthetic_frame(width, height, 1);
    expect_mask_round_trip(frame.seen, frame.depth_mm);
    MaskImage noise(width, height);
    for (std::size_t i = 0; i < noise.view().pixel_count(); ++i) {
      noise.data()[i] = static_cast<std::uint8_t>(random() & random());
    }
    for (const NamedDepth& depth : synthetic_depths(width, height)) {
      expect_mask_round_trip(noise, depth.depth_mm);
      expect_mask_round_trip(MaskImage(width, height, 255), depth.depth_mm);
      expect_mask_round_trip(MaskImage(width, height, 0), depth.depth_mm);
    }
  }
}

TEST(IntraMask, a_mask_like_a_sensors_takes_far_less_than_a_bit_per_pixel) {
  const SyntheticFrame frame = synthetic_frame(320, 240, 1);
  EXPECT_LT(encoded_mask(frame.seen, frame.depth_mm).size(), 320u * 240u / 8 / 20);
  EXPECT_LT(encoded_mask(MaskImage(320, 240, 255), frame.depth_mm).size(), 20u);
}

TEST(IntraMask, garbage_gives_some_mask) {
  std::mt19937 random(6);
  const DepthImage depth = synthetic_room(40, 30, 1);
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<std::uint8_t> bytes(random() % 200);
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
    const MaskImage known = decoded(bytes, depth);
    for (std::size_t i = 0; i < known.view().pixel_count(); ++i) ASSERT_LE(known.data()[i], 1);
  }
}

}  // namespace
}  // namespace roomcast::codec
