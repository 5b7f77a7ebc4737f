// SPDX-License-Identifier: Apache-2.0
// The live depth decoder on bytes that no encoder of ours writes.
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/codec/live/live_depth_decoder.h"
#include "roomcast/codec/testing/random_live_stream.h"

namespace roomcast::codec {
namespace {

constexpr int kHostileWidth = 61, kHostileHeight = 37;

std::vector<std::uint16_t> pixels_of(const DepthImage& image) {
  return {image.data(), image.data() + image.view().pixel_count()};
}

/// Sets the section's hash to the result of decoding it, so that the decoder continues from it.
void make_acceptable(const LiveDepthDecoder& decoder, std::vector<std::uint8_t>& section,
                     ImageView<std::uint16_t> out) {
  LiveDepthDecoder trial = decoder;
  if (section.size() < 6 || trial.decode(section, out).ok()) return;
  write_u32(&section[kLiveHashOffset], trial.state().hash);
}

TEST(LiveHostile, every_corner_of_the_format_decodes_to_what_was_written) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    RandomLiveStream stream(kHostileWidth, kHostileHeight, seed);
    LiveDepthDecoder decoder;
    DepthImage out(kHostileWidth, kHostileHeight);
    for (int i = 0; i < 12; ++i) {
      const auto section = stream.next(i % 9 == 0, i % 2 == 0);
      ASSERT_TRUE(decoder.decode(section, out.view()).ok()) << seed << "," << i;
      ASSERT_EQ(pixels_of(out), stream.shown_mm()) << seed << "," << i;
    }
  }
}

// Under the sanitizers this test detects the errors that a fuzzer would find early.
TEST(LiveHostile, any_damage_is_survived_even_when_the_hash_fits) {
  std::mt19937 random(5);
  DepthImage out(kHostileWidth, kHostileHeight);
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    RandomLiveStream stream(kHostileWidth, kHostileHeight, seed);
    LiveDepthDecoder decoder;
    for (int i = 0; i < 10; ++i) {
      auto section = stream.next(i == 0, i % 3 != 2);
      for (int flip = 0; flip < 4; ++flip) {
        section[6 + random() % (section.size() - 6)] = static_cast<std::uint8_t>(random());
      }
      if (section[1] < 4) section[1] = 4;
      make_acceptable(decoder, section, out.view());
      (void)decoder.decode(section, out.view());
    }
    const auto key = RandomLiveStream(kHostileWidth, kHostileHeight, seed).next(true, true);
    ASSERT_TRUE(decoder.decode(key, out.view()).ok());
  }
}

TEST(LiveHostile, a_truncated_section_is_refused) {
  const auto key = RandomLiveStream(kHostileWidth, kHostileHeight, 1).next(true, true);
  LiveDepthDecoder decoder;
  DepthImage out(kHostileWidth, kHostileHeight);
  for (std::size_t length = 0; length + 8 < key.size(); ++length) {
    const std::span<const std::uint8_t> cut(key.data(), length);
    ASSERT_FALSE(decoder.decode(cut, out.view()).ok()) << length;
  }
}

TEST(LiveHostile, a_damaged_noise_table_is_noticed) {
  const auto key = RandomLiveStream(kHostileWidth, kHostileHeight, 1).next(true, true);
  LiveDepthDecoder decoder;
  DepthImage out(kHostileWidth, kHostileHeight);
  for (std::size_t at = 7; at < 7 + kSigmaKnotCount; ++at) {
    std::vector<std::uint8_t> bytes = key;
    bytes[at] ^= 1;
    EXPECT_FALSE(decoder.decode(bytes, out.view()).ok()) << at;
  }
}

TEST(LiveHostile, flags_of_a_later_version_and_illegal_steps_are_refused) {
  const auto key = RandomLiveStream(kHostileWidth, kHostileHeight, 1).next(true, true);
  LiveDepthDecoder decoder;
  DepthImage out(kHostileWidth, kHostileHeight);
  const auto refusal_with = [&](std::size_t at, std::uint8_t value) {
    std::vector<std::uint8_t> bytes = key;
    bytes[at] = value;
    const Status status = decoder.decode(bytes, out.view());
    return status.ok() ? ErrorCode::kInvalidArgument : status.error().code;
  };
  EXPECT_EQ(refusal_with(0, 7), ErrorCode::kUnsupported);
  EXPECT_EQ(refusal_with(0, 1), ErrorCode::kMalformed);  // a key frame that is no reference
  EXPECT_EQ(refusal_with(1, 3), ErrorCode::kMalformed);
  EXPECT_EQ(refusal_with(6, 0), ErrorCode::kMalformed);
}

TEST(LiveHostile, a_frame_of_another_size_needs_a_key_frame) {
  RandomLiveStream stream(kHostileWidth, kHostileHeight, 1);
  LiveDepthDecoder decoder;
  DepthImage out(kHostileWidth, kHostileHeight), other(kHostileWidth + 3, kHostileHeight);
  ASSERT_TRUE(decoder.decode(stream.next(true, true), out.view()).ok());
  EXPECT_FALSE(decoder.decode(stream.next(false, true), other.view()).ok());
}

}  // namespace
}  // namespace roomcast::codec
