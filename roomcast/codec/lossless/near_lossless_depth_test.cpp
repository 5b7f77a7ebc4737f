// SPDX-License-Identifier: Apache-2.0
// Near-lossless depth: no reading is off by more than the bound, none is lost or added, and
// anything that is not a section is refused.
#include <random>

#include <gtest/gtest.h>

#include "roomcast/codec/lossless/lossless_depth_decoder.h"
#include "roomcast/codec/lossless/lossless_depth_encoder.h"
#include "roomcast/codec/lossless/residual.h"
#include "roomcast/codec/testing/synthetic_depth.h"

namespace roomcast::codec {
namespace {

std::vector<std::uint8_t> encoded_within(DepthView depth, int bound_mm) {
  LosslessDepthEncoder encoder;
  std::vector<std::uint8_t> section;
  encoder.encode_near_lossless(depth, bound_mm, section);
  return section;
}

void expect_within(const DepthImage& in, DepthView out, int bound_mm) {
  for (int y = 0; y < in.height(); ++y) {
    for (int x = 0; x < in.width(); ++x) {
      ASSERT_EQ(in.at(x, y) == 0, out.at(x, y) == 0) << x << ", " << y;
      ASSERT_LE(std::abs(in.at(x, y) - out.at(x, y)), bound_mm) << x << ", " << y;
    }
  }
}

class NearLosslessBounds : public testing::TestWithParam<int> {};

TEST_P(NearLosslessBounds, every_reading_comes_back_within_the_bound) {
  const int bound = GetParam();
  for (const auto& [width, height] : {std::pair{16, 17}, std::pair{33, 31}, std::pair{127, 65}}) {
    for (const NamedDepth& picture : synthetic_depths(width, height)) {
      SCOPED_TRACE(picture.name);
      LosslessDepthEncoder encoder;
      std::vector<std::uint8_t> section;
      encoder.encode_near_lossless(picture.depth_mm, bound, section);
      DepthImage out(width, height);
      const Status status = LosslessDepthDecoder().decode_near_lossless(section, out.view());
      ASSERT_TRUE(status.ok()) << status.error().message;
      expect_within(picture.depth_mm, out, bound);
      expect_within(out, encoder.decoded_mm(), 0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Bounds, NearLosslessBounds, testing::Values(1, 2, 5, 20, 63));

TEST(BoundedResidual, is_within_the_bound_and_never_zero_at_the_ends_of_the_range) {
  for (const int bound : {1, 2, 5, 63}) {
    const BoundedResidual residual(bound);
    for (const int value : {1, 2, 63, 64, 1000, 65472, 65534, 65535}) {
      for (const int prediction : {-100000, -1, 0, 1, 900, 1100, 65535, 65600, 200000}) {
        const int decoded = residual.value(prediction, residual.error(value, prediction));
        EXPECT_LE(std::abs(decoded - value), bound) << value << " from " << prediction;
        EXPECT_GT(decoded, 0);
      }
    }
  }
}

TEST(NearLosslessDepth, a_larger_bound_takes_fewer_bytes) {
  const DepthImage room = synthetic_room(320, 240, 4);
  std::size_t before = encoded_within(room, 1).size();
  for (const int bound : {2, 5, 10}) {
    const std::size_t now = encoded_within(room, bound).size();
    EXPECT_LT(now, before);
    before = now;
  }
}

TEST(NearLosslessDepth, few_distances_are_sent_as_indices_still) {
  const DepthImage room = synthetic_disparity_room(320, 240);
  EXPECT_EQ(encoded_within(room, 1)[0], 0) << "exact indices";
  EXPECT_EQ(encoded_within(synthetic_room(320, 240, 3), 1)[0], 1);
}

TEST(NearLosslessDepth, decode_refuses_a_section_cut_anywhere) {
  const auto section = encoded_within(synthetic_room(48, 32, 1), 2);
  LosslessDepthDecoder decoder;
  DepthImage out(48, 32);
  for (std::size_t length = 0; length < section.size(); ++length) {
    const Status status =
        decoder.decode_near_lossless(std::span(section).first(length), out.view());
    ASSERT_FALSE(status.ok()) << length;
    ASSERT_EQ(status.error().code, ErrorCode::kMalformed);
  }
}

TEST(NearLosslessDepth, decode_refuses_a_bound_out_of_range_and_one_beside_a_table) {
  DepthImage out(48, 32);
  auto section = encoded_within(synthetic_room(48, 32, 1), 2);
  section[0] = kMaxBound_mm + 1;
  EXPECT_FALSE(LosslessDepthDecoder().decode_near_lossless(section, out.view()).ok());
  auto mapped = encoded_within(synthetic_disparity_room(48, 32), 1);
  ASSERT_EQ(mapped[0], 0);
  mapped[0] = 1;
  EXPECT_FALSE(LosslessDepthDecoder().decode_near_lossless(mapped, out.view()).ok());
}

TEST(NearLosslessDepth, decode_survives_flipped_bits_and_garbage) {
  const auto good = encoded_within(synthetic_room(48, 32, 1), 2);
  LosslessDepthDecoder decoder;
  DepthImage out(48, 32);
  std::mt19937 random(3);
  for (int trial = 0; trial < 3000; ++trial) {
    auto section = good;
    for (int flips = 1 + static_cast<int>(random() % 8); flips > 0; --flips) {
      section[random() % section.size()] ^= static_cast<std::uint8_t>(1 << random() % 8);
    }
    (void)decoder.decode_near_lossless(section, out.view());
  }
}

}  // namespace
}  // namespace roomcast::codec
