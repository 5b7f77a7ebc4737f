// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/utf8.h"

#include <string_view>

#include <gtest/gtest.h>

namespace roomcast::net {
namespace {

using namespace std::string_view_literals;

TEST(Utf8, accepts_the_first_and_last_character_of_every_length) {
  for (const auto text : {""sv, "\0"sv, "\x7F"sv, "\xC2\x80"sv, "\xDF\xBF"sv, "\xE0\xA0\x80"sv,
                          "\xED\x9F\xBF"sv, "\xEE\x80\x80"sv, "\xEF\xBF\xBF"sv,
                          "\xF0\x90\x80\x80"sv, "\xF4\x8F\xBF\xBF"sv, "a\xC3\xA9z"sv}) {
    EXPECT_TRUE(is_utf8(text));
  }
}

TEST(Utf8, refuses_sequences_that_unicode_forbids) {
  EXPECT_FALSE(is_utf8("\x80")) << "continuation without a beginning";
  EXPECT_FALSE(is_utf8("\xC3")) << "cut off";
  EXPECT_FALSE(is_utf8("\xC3z")) << "not continued";
  EXPECT_FALSE(is_utf8("\xC0\xAF")) << "overlong";
  EXPECT_FALSE(is_utf8("\xE0\x9F\xBF")) << "overlong";
  EXPECT_FALSE(is_utf8("\xF0\x8F\xBF\xBF")) << "overlong";
  EXPECT_FALSE(is_utf8("\xED\xA0\x80")) << "surrogate";
  EXPECT_FALSE(is_utf8("\xF4\x90\x80\x80")) << "beyond U+10FFFF";
  EXPECT_FALSE(is_utf8("\xFF"));
  EXPECT_FALSE(is_utf8("\xF0\x9F\x98")) << "cut off";
}

}  // namespace
}  // namespace roomcast::net
