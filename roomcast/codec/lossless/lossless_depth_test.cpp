// SPDX-License-Identifier: Apache-2.0
// Encoder and decoder of lossless depth together: round trips are exact, and anything that is not a
// section is refused.
#include <random>

#include <gtest/gtest.h>

#include "roomcast/codec/lossless/lossless_depth_decoder.h"
#include "roomcast/codec/lossless/lossless_depth_encoder.h"
#include "roomcast/codec/testing/synthetic_depth.h"
#include "roomcast/core/little_endian.h"

namespace roomcast::codec {
namespace {

std::vector<std::uint8_t> encoded(DepthView depth) {
  LosslessDepthEncoder encoder;
  std::vector<std::uint8_t> section;
  encoder.encode(depth, section);
  return section;
}

void expect_round_trip(const NamedDepth& picture) {
  const auto section = encoded(picture.depth_mm);
  LosslessDepthDecoder decoder;
  DepthImage out(picture.depth_mm.width(), picture.depth_mm.height());
  const Status status = decoder.decode(section, out.view());
  ASSERT_TRUE(status.ok()) << picture.name << ": " << status.error().message;
  EXPECT_EQ(out, picture.depth_mm) << picture.name;
}

class LosslessDepthSizes : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(LosslessDepthSizes, gives_back_every_bit) {
  const auto [width, height] = GetParam();
  for (const NamedDepth& picture : synthetic_depths(width, height)) expect_round_trip(picture);
}

INSTANTIATE_TEST_SUITE_P(Sizes, LosslessDepthSizes,
                         testing::Values(std::pair{16, 16}, std::pair{17, 16}, std::pair{16, 17},
                                         std::pair{33, 31}, std::pair{127, 65},
                                         std::pair{320, 240}));

TEST(LosslessDepth, gives_back_every_bit_of_the_largest_width) {
  expect_round_trip({"wide", synthetic_room(4096, 16, 5)});
  expect_round_trip({"tall", synthetic_room(16, 4096, 5)});
}

TEST(LosslessDepth, reads_a_picture_with_gaps_between_its_rows) {
  const DepthImage whole = synthetic_room(64, 48, 2);
  const DepthView part{whole.data() + 5, 40, 48, 64};
  LosslessDepthDecoder decoder;
  DepthImage out(64, 48);
  ASSERT_TRUE(decoder.decode(encoded(part), {out.data() + 5, 40, 48, 64}).ok());
  for (int y = 0; y < 48; ++y) {
    EXPECT_EQ(out.at(4, y), 0);
    EXPECT_EQ(out.at(5, y), whole.at(5, y));
    EXPECT_EQ(out.at(44, y), whole.at(44, y));
    EXPECT_EQ(out.at(45, y), 0);
  }
}

TEST(LosslessDepth, the_same_picture_gives_the_same_bytes_after_any_other) {
  LosslessDepthEncoder encoder;
  std::vector<std::uint8_t> before, after;
  encoder.encode(synthetic_disparity_room(64, 48), before);
  encoder.encode(synthetic_room(64, 48, 1), after);
  EXPECT_EQ(after, encoded(synthetic_room(64, 48, 1)));
}

TEST(LosslessDepth, a_smooth_picture_takes_far_less_than_its_noise_would) {
  const DepthImage ramp = depth_from(320, 240, [](int x, int y) { return 800 + 3 * x + 5 * y; });
  EXPECT_LT(encoded(ramp).size(), 320u * 240u / 32);
}

TEST(LosslessDepth, few_distances_are_sent_as_indices) {
  const DepthImage room = synthetic_disparity_room(320, 240);
  const auto section = encoded(room);
  EXPECT_TRUE(section[8] & 0x80) << "the first bit of the side information says so";
  EXPECT_LT(section.size() * 3, encoded(synthetic_room(320, 240, 3)).size() * 2);
}

TEST(LosslessDepth, decode_refuses_a_section_cut_anywhere) {
  const auto section = encoded(synthetic_room(48, 32, 1));
  LosslessDepthDecoder decoder;
  DepthImage out(48, 32);
  for (std::size_t length = 0; length < section.size(); ++length) {
    const Status status = decoder.decode(std::span(section).first(length), out.view());
    ASSERT_FALSE(status.ok()) << length;
    ASSERT_EQ(status.error().code, ErrorCode::kMalformed);
  }
}

TEST(LosslessDepth, decode_refuses_bytes_after_the_end) {
  auto section = encoded(synthetic_room(48, 32, 1));
  section.insert(section.end(), 2, 0);
  DepthImage out(48, 32);
  EXPECT_FALSE(LosslessDepthDecoder().decode(section, out.view()).ok());
}

TEST(LosslessDepth, decode_refuses_a_picture_of_another_size) {
  const auto section = encoded(synthetic_room(48, 32, 1));
  DepthImage out(48, 34);
  EXPECT_FALSE(LosslessDepthDecoder().decode(section, out.view()).ok());
}

TEST(LosslessDepth, decode_refuses_lengths_that_do_not_add_up) {
  const auto good = encoded(synthetic_room(48, 32, 1));
  DepthImage out(48, 32);
  for (const std::size_t at : {0u, 4u}) {
    for (const std::uint32_t length :
         {0xFFFFFFFFu, 0x80000000u, static_cast<std::uint32_t>(good.size())}) {
      auto section = good;
      write_u32(&section[at], length);
      EXPECT_FALSE(LosslessDepthDecoder().decode(section, out.view()).ok());
    }
  }
}

// Usually the check at the slices' ends detects them; required is only that nothing crashes and
// memory stays bounded.
TEST(LosslessDepth, decode_survives_flipped_bits) {
  const auto good = encoded(synthetic_disparity_room(48, 32));
  LosslessDepthDecoder decoder;
  DepthImage out(48, 32);
  int refused = 0;
  for (std::size_t bit = 0; bit < good.size() * 8; ++bit) {
    auto section = good;
    section[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
    refused += !decoder.decode(section, out.view()).ok();
  }
  EXPECT_GT(refused, static_cast<int>(good.size() * 8 * 9 / 10));
}

TEST(LosslessDepth, decode_survives_garbage) {
  std::mt19937 random(11);
  LosslessDepthDecoder decoder;
  DepthImage out(48, 32);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<std::uint8_t> section(random() % 600);
    for (auto& byte : section) byte = static_cast<std::uint8_t>(random());
    if (section.size() > 300) {  // legal lengths, so that the garbage after them is parsed
      write_u32(&section[0], 100);
      write_u32(&section[4], 100);
    }
    (void)decoder.decode(section, out.view());
  }
}

}  // namespace
}  // namespace roomcast::codec
