// SPDX-License-Identifier: Apache-2.0
#include "roomcast/wire/name_check.h"

#include <string>

#include <gtest/gtest.h>

#include "roomcast/wire/limits.h"

namespace roomcast::wire {
namespace {

TEST(NameCheck, people_may_use_their_own_script) {
  for (const char* name : {"", "s0", "Émilie’s desk", "会議室", "🎥 left", "\xF4\x8F\xBF\xBF"}) {
    EXPECT_TRUE(check_name(name, "sensor").ok()) << name;
  }
}

TEST(NameCheck, control_characters_are_refused) {
  for (const char* name : {"a\nb", "\t", "\x7F", "\x1B[31m", "\xC2\x85"}) {
    EXPECT_FALSE(check_name(name, "sensor").ok()) << name;
  }
  EXPECT_FALSE(check_name(std::string("a\0b", 3), "sensor").ok());
}

TEST(NameCheck, bytes_that_are_not_utf8_are_refused) {
  for (const char* name : {"\x80", "\xC3", "\xC0\xAF", "\xE0\x80\x80", "\xED\xA0\x80",
                           "\xF4\x90\x80\x80", "\xF8\x88\x80\x80\x80", "\xFF", "ok\xE2\x82"}) {
    EXPECT_FALSE(check_name(name, "sensor").ok()) << name;
  }
}

TEST(NameCheck, the_limit_counts_bytes) {
  EXPECT_TRUE(check_name(std::string(kMaxNameBytes, 'a'), "room").ok());
  const auto status = check_name(std::string(kMaxNameBytes + 1, 'a'), "room");
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::kTooLarge);
  EXPECT_EQ(status.error().message, "the room's name is longer than 64 bytes");
}

}  // namespace
}  // namespace roomcast::wire
