// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/framed_message.h"

#include <array>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast::net {
namespace {

using ::testing::ElementsAre;
using ::testing::ElementsAreArray;

TEST(FramedMessage, puts_the_header_in_front_without_moving_the_payload) {
  MessageBuffer message(std::vector<std::uint8_t>(70'000, 5));
  const auto* payload = message.payload().data();
  const auto sealed = frame_message(std::move(message));
  EXPECT_EQ(sealed->payload().data(), payload);
  EXPECT_EQ(sealed->wire_bytes().size(), 70'010U);
  EXPECT_THAT(sealed->wire_bytes().first(10), ElementsAre(0x82, 127, 0, 0, 0, 0, 0, 1, 0x11, 0x70));
}

TEST(FramedMessage, an_empty_message_is_its_header) {
  EXPECT_THAT(frame_message(MessageBuffer())->wire_bytes(), ElementsAre(0x82, 0));
}

TEST(FramedMessage, seals_the_masked_hello_of_rfc_6455) {
  // RFC 6455 section 5.7, with the opcode of a pong: "a masked Pong containing 'Hello'".
  const std::array<std::uint8_t, 5> hello = {'H', 'e', 'l', 'l', 'o'};
  const auto sealed =
      frame_message(MessageBuffer(hello), Opcode::kPong, MaskKey{0x37, 0xfa, 0x21, 0x3d});
  EXPECT_THAT(sealed->wire_bytes(),
              ElementsAre(0x8a, 0x85, 0x37, 0xfa, 0x21, 0x3d, 0x7f, 0x9f, 0x4d, 0x51, 0x58));
}

TEST(FramedMessage, a_masked_copy_leaves_the_original_as_it_was) {
  const std::array<std::uint8_t, 3> bytes = {1, 2, 3};
  const auto plain = frame_message(MessageBuffer(bytes));
  const auto masked = frame_masked_copy(*plain, {0xFF, 0xFF, 0xFF, 0xFF});
  EXPECT_THAT(plain->payload(), ElementsAreArray(bytes));
  EXPECT_THAT(masked->wire_bytes(),
              ElementsAre(0x82, 0x83, 0xFF, 0xFF, 0xFF, 0xFF, 0xFE, 0xFD, 0xFC));
}

TEST(FramedMessageDeathTest, an_oversized_control_frame_is_a_broken_promise) {
  EXPECT_DEATH((void)frame_message(MessageBuffer(std::vector<std::uint8_t>(126)), Opcode::kPing),
               "");
}

}  // namespace
}  // namespace roomcast::net
