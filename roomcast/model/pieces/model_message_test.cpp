// SPDX-License-Identifier: Apache-2.0
#include "roomcast/model/pieces/model_message.h"

#include <gtest/gtest.h>

namespace roomcast::model {
namespace {

std::vector<std::uint8_t> bytes_of(const std::string& text) {
  return {text.begin(), text.end()};
}

std::vector<std::uint8_t> example() {
  static const std::vector<std::uint8_t> kDraco = {1, 2, 3};
  return bytes_of(write_model_message({.is_whole = true,
                                       .version = 0x1'0000'0002,
                                       .pieces = {{{-1, 0, 7}, kDraco}, {{2, 2, 2}, {}}}}));
}

TEST(ModelMessage, is_read_as_it_was_written) {
  const auto bytes = example();
  const auto message = read_model_message(bytes);
  ASSERT_TRUE(message.ok());
  EXPECT_TRUE(message->is_whole);
  EXPECT_EQ(message->version, 0x1'0000'0002u);
  ASSERT_EQ(message->pieces.size(), 2u);
  EXPECT_EQ(message->pieces[0].place, (GridPlace{-1, 0, 7}));
  EXPECT_EQ(message->pieces[0].draco.size(), 3u);
  EXPECT_EQ(message->pieces[0].draco[2], 3);
  EXPECT_TRUE(message->pieces[1].draco.empty());
}

TEST(ModelMessage, the_bytes_are_those_of_the_spec) {
  const std::vector<std::uint8_t> expected = {
      'R',  'C',  'M',  1,    1, 0, 0, 0, 2, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0,  //
      0xFF, 0xFF, 0xFF, 0xFF, 0, 0, 0, 0, 7, 0, 0, 0, 3, 0, 0, 0, 1, 2, 3,     //
      2,    0,    0,    0,    2, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0};
  EXPECT_EQ(example(), expected);
}

TEST(ModelMessage, what_is_cut_off_or_has_more_is_refused) {
  auto bytes = example();
  for (std::size_t length = 0; length < bytes.size(); ++length)
    EXPECT_FALSE(read_model_message(std::span(bytes).first(length)).ok()) << length;
  bytes.push_back(0);
  EXPECT_FALSE(read_model_message(bytes).ok());
}

TEST(ModelMessage, a_count_that_cannot_be_is_refused) {
  auto bytes = example();
  bytes[19] = 0xFF;
  EXPECT_EQ(read_model_message(bytes).error().code, ErrorCode::kMalformed);
}

TEST(ModelMessage, a_later_version_is_named_so) {
  auto bytes = example();
  bytes[3] = 2;
  EXPECT_EQ(read_model_message(bytes).error().code, ErrorCode::kUnsupported);
}

}  // namespace
}  // namespace roomcast::model
