// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/color/vp9_header.h"

#include <vector>

#include <gtest/gtest.h>

namespace roomcast::codec {
namespace {

/// Writes bits, highest first.
class BitRow {
 public:
  BitRow& put(std::uint32_t value, int count) {
    for (int i = count - 1; i >= 0; --i) {
      if (used_ % 8 == 0) bytes_.push_back(0);
      bytes_.back() |= static_cast<std::uint8_t>((value >> i & 1) << (7 - used_ % 8));
      ++used_;
    }
    return *this;
  }
  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
  int used_ = 0;
};

BitRow start(std::uint32_t profile, bool repeats, bool inter, bool shown, bool resilient) {
  return BitRow()
      .put(2, 2)
      .put(profile, 2)
      .put(repeats, 1)
      .put(inter, 1)
      .put(shown, 1)
      .put(resilient, 1);
}

BitRow key_frame(std::uint32_t width, std::uint32_t height) {
  return start(0, false, false, true, false)
      .put(0x498342, 24)
      .put(2, 3)
      .put(0, 1)
      .put(width - 1, 16)
      .put(height - 1, 16);
}

TEST(Vp9Header, reads_the_size_of_a_key_frame) {
  const auto header = parse_vp9_header(key_frame(512, 424).bytes());
  ASSERT_TRUE(header.ok());
  EXPECT_TRUE(header->key);
  EXPECT_EQ(header->width, 512);
  EXPECT_EQ(header->height, 424);
  EXPECT_EQ(parse_vp9_header(key_frame(65536, 1).bytes())->width, 65536);
}

TEST(Vp9Header, a_frame_that_takes_a_references_size_says_none) {
  for (const bool resilient : {false, true}) {
    BitRow bits = start(0, false, true, true, resilient);
    if (!resilient) bits.put(0, 2);
    bits.put(1, 8).put(0, 12).put(1, 1);
    const auto header = parse_vp9_header(bits.bytes());
    ASSERT_TRUE(header.ok());
    EXPECT_FALSE(header->key);
    EXPECT_EQ(header->width, 0);
  }
}

TEST(Vp9Header, finds_the_size_that_an_inter_frame_hides) {
  BitRow bits = start(0, false, true, true, true).put(1, 8).put(0, 12).put(0, 3);
  bits.put(15999, 16).put(15999, 16);
  EXPECT_EQ(parse_vp9_header(bits.bytes())->width, 16000);
}

TEST(Vp9Header, refuses_frames_that_colour_sections_do_not_carry) {
  EXPECT_EQ(parse_vp9_header(start(1, false, false, true, false).bytes()).error().code,
            ErrorCode::kUnsupported);
  EXPECT_EQ(parse_vp9_header(start(0, true, false, true, false).bytes()).error().code,
            ErrorCode::kUnsupported);
  EXPECT_EQ(parse_vp9_header(start(0, false, true, false, false).bytes()).error().code,
            ErrorCode::kUnsupported);
}

TEST(Vp9Header, refuses_cut_and_damaged_frames) {
  const std::vector<std::uint8_t> good = key_frame(64, 48).bytes();
  for (std::size_t length = 0; length < good.size(); ++length) {
    EXPECT_FALSE(parse_vp9_header(std::span(good).first(length)).ok()) << length;
  }
  std::vector<std::uint8_t> bad = good;
  bad[2] ^= 1;  // the sync code
  EXPECT_FALSE(parse_vp9_header(bad).ok());
}

}  // namespace
}  // namespace roomcast::codec
