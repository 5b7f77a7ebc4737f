// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/peers/temporal_rvl.h"

#include <random>

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

using Frame = std::vector<std::uint16_t>;

/// Codes one pixel's values with a threshold of 10 mm; the first frame is a key frame.
Frame decoded(const Frame& readings) {
  TemporalRvlEncoder encoder(1, 10);
  TemporalRvlDecoder decoder(1);
  Frame out;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    std::vector<std::uint8_t> bytes;
    encoder.encode(std::span(&readings[i], 1), i == 0, bytes);
    out.push_back(decoder.decode(bytes, i == 0)[0]);
  }
  return out;
}

TEST(TemporalRvl, keeps_a_value_up_to_the_threshold) {
  EXPECT_EQ(decoded({1000, 1010, 990, 1011, 1001}), (Frame{1000, 1000, 1000, 1011, 1011}));
}

TEST(TemporalRvl, a_hole_counts_when_it_comes_twice) {
  EXPECT_EQ(decoded({1000, 0, 1000, 0, 0, 1005}), (Frame{1000, 1000, 1000, 1000, 0, 1005}));
}

TEST(TemporalRvl, is_off_by_the_threshold_at_most) {
  constexpr std::size_t kPixels = 400;
  std::mt19937 random(5);
  TemporalRvlEncoder encoder(kPixels, 10);
  TemporalRvlDecoder decoder(kPixels);
  for (int frame = 0; frame < 30; ++frame) {
    Frame depth(kPixels);
    for (auto& d : depth) d = static_cast<std::uint16_t>(2000 + random() % 60);
    std::vector<std::uint8_t> bytes;
    encoder.encode(depth, frame % 10 == 0, bytes);
    const auto out = decoder.decode(bytes, frame % 10 == 0);
    for (std::size_t i = 0; i < kPixels; ++i) ASSERT_LE(std::abs(out[i] - depth[i]), 10);
  }
}

}  // namespace
}  // namespace roomcast::bench
