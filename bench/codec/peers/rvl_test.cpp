// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/peers/rvl.h"

#include <random>

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

std::vector<std::uint8_t> encoded(const std::vector<std::uint16_t>& depth) {
  std::vector<std::uint8_t> bytes;
  encode_rvl(std::span(depth), bytes);
  return bytes;
}

TEST(Rvl, gives_back_every_value) {
  std::mt19937 random(1);
  for (const std::size_t size : {0u, 1u, 7u, 8u, 500u}) {
    for (const std::uint32_t holes_in_ten : {0u, 3u, 10u}) {
      std::vector<std::uint16_t> depth(size), out(size, 9);
      for (auto& d : depth) {
        d = random() % 10 < holes_in_ten ? 0 : static_cast<std::uint16_t>(random());
      }
      decode_rvl(encoded(depth), std::span(out));
      EXPECT_EQ(out, depth);
    }
  }
}

TEST(Rvl, gives_back_negative_differences) {
  const std::vector<std::int16_t> differences = {0, -3, 4, 0, -32768, 32767, 0};
  std::vector<std::int16_t> out(differences.size());
  std::vector<std::uint8_t> bytes;
  encode_rvl(std::span(differences), bytes);
  decode_rvl(bytes, std::span(out));
  EXPECT_EQ(out, differences);
}

// 2 holes, 3 readings, then the differences 5, 1, -1 folded to 10 (two nibbles: 2 and more, 1),
// 2, 1.
TEST(Rvl, packs_nibbles_as_the_paper_says) {
  EXPECT_EQ(encoded({0, 0, 5, 6, 5}), (std::vector<std::uint8_t>{0x00, 0x21, 0xA1, 0x23}));
}

}  // namespace
}  // namespace roomcast::bench
