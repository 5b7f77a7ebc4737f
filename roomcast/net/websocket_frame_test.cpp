// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/websocket_frame.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast::net {
namespace {

using ::testing::ElementsAre;

TEST(WebSocketFrame, writes_the_shortest_length_form) {
  EXPECT_THAT(make_frame_header(Opcode::kBinary, 0).view(), ElementsAre(0x82, 0));
  EXPECT_THAT(make_frame_header(Opcode::kBinary, 125).view(), ElementsAre(0x82, 125));
  EXPECT_THAT(make_frame_header(Opcode::kBinary, 126).view(), ElementsAre(0x82, 126, 0, 126));
  EXPECT_THAT(make_frame_header(Opcode::kBinary, 65535).view(), ElementsAre(0x82, 126, 0xFF, 0xFF));
  EXPECT_THAT(make_frame_header(Opcode::kBinary, 65536).view(),
              ElementsAre(0x82, 127, 0, 0, 0, 0, 0, 1, 0, 0));
}

TEST(WebSocketFrame, matches_the_binary_examples_of_rfc_6455) {
  EXPECT_THAT(make_frame_header(Opcode::kBinary, 256).view(), ElementsAre(0x82, 0x7E, 0x01, 0x00));
  EXPECT_THAT(make_frame_header(Opcode::kPing, 5).view(), ElementsAre(0x89, 0x05));
}

TEST(WebSocketFrame, a_masked_header_ends_with_the_key) {
  EXPECT_THAT(make_frame_header(Opcode::kBinary, 300, MaskKey{1, 2, 3, 4}).view(),
              ElementsAre(0x82, 0xFE, 0x01, 0x2C, 1, 2, 3, 4));
}

TEST(WebSocketFrame, masks_as_the_plain_definition_for_every_length_and_phase) {
  const MaskKey key = {0x11, 0x22, 0x44, 0x88};
  for (std::size_t size = 0; size < 40; ++size) {
    for (std::size_t phase = 0; phase < 9; ++phase) {
      std::vector<std::uint8_t> from(size);
      for (std::size_t i = 0; i < size; ++i) from[i] = static_cast<std::uint8_t>(37 * i + 1);
      std::vector<std::uint8_t> to(size);
      mask_copy(to, from, key, phase);
      for (std::size_t i = 0; i < size; ++i) ASSERT_EQ(to[i], from[i] ^ key[(phase + i) % 4]);
      mask_copy(to, to, key, phase);
      ASSERT_EQ(to, from) << "in place, and back";
    }
  }
}

TEST(WebSocketFrame, knows_which_close_codes_may_be_sent) {
  for (const int code : {1000, 1001, 1002, 1003, 1007, 1008, 1009, 1011, 1013, 1014, 3000, 4999}) {
    EXPECT_TRUE(may_be_sent(static_cast<std::uint16_t>(code))) << code;
  }
  for (const int code : {0, 999, 1004, 1005, 1006, 1015, 1016, 2999, 5000, 65535}) {
    EXPECT_FALSE(may_be_sent(static_cast<std::uint16_t>(code))) << code;
  }
}

TEST(WebSocketFrame, cuts_a_long_reason_at_a_characters_border) {
  EXPECT_EQ(cut_close_reason("short"), "short");
  EXPECT_EQ(cut_close_reason(std::string(123, 'x')).size(), 123U);
  EXPECT_EQ(cut_close_reason(std::string(124, 'x')).size(), 123U);
  const std::string two_byte_character_across = std::string(122, 'x') + "\xC3\xA9" + "y";
  EXPECT_EQ(cut_close_reason(two_byte_character_across), std::string(122, 'x'));
  const std::string four_byte_character_across = std::string(120, 'x') + "\xF0\x9F\x98\x80" + "y";
  EXPECT_EQ(cut_close_reason(four_byte_character_across), std::string(120, 'x'));
}

}  // namespace
}  // namespace roomcast::net
