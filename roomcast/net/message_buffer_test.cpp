// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/message_buffer.h"

#include <array>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast::net {
namespace {

using ::testing::ElementsAre;

TEST(MessageBuffer, is_empty_until_something_is_put_in) {
  const MessageBuffer buffer;
  EXPECT_TRUE(buffer.empty());
  EXPECT_EQ(buffer.payload().size(), 0U);
}

TEST(MessageBuffer, keeps_appended_bytes_in_order) {
  MessageBuffer buffer(std::array<std::uint8_t, 2>{1, 2});
  buffer.append(std::array<std::uint8_t, 1>{3});
  EXPECT_THAT(buffer.payload(), ElementsAre(1, 2, 3));
}

TEST(MessageBuffer, payload_can_be_changed_in_place) {
  MessageBuffer buffer(std::array<std::uint8_t, 2>{1, 2});
  buffer.payload()[1] = 9;
  EXPECT_THAT(buffer.payload(), ElementsAre(1, 9));
}

TEST(MessageBuffer, an_encoder_appends_after_the_headroom) {
  MessageBuffer buffer;
  EXPECT_EQ(buffer.appendable().size(), MessageBuffer::kHeadroom);
  buffer.appendable().push_back(7);
  EXPECT_THAT(buffer.payload(), ElementsAre(7));
}

TEST(MessageBuffer, reserved_payload_is_appended_without_moving) {
  MessageBuffer buffer;
  buffer.reserve(1000);
  const auto* before = buffer.appendable().data();
  buffer.append(std::vector<std::uint8_t>(1000));
  EXPECT_EQ(buffer.appendable().data(), before);
}

TEST(MessageBuffer, moved_from_and_released_buffers_are_empty_and_can_be_used_again) {
  MessageBuffer buffer(std::array<std::uint8_t, 1>{1});
  const MessageBuffer moved = std::move(buffer);
  EXPECT_EQ(moved.size(), 1U);
  EXPECT_TRUE(buffer.empty());  // NOLINT: this use after move is tested
  buffer.append(std::array<std::uint8_t, 1>{2});
  EXPECT_EQ(std::move(buffer).release().size(), MessageBuffer::kHeadroom + 1);
  EXPECT_TRUE(buffer.empty());  // NOLINT
}

}  // namespace
}  // namespace roomcast::net
