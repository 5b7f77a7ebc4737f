// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/utc_text.h"

#include <gtest/gtest.h>

namespace roomcast {
namespace {

TEST(UtcText, is_iso_8601_to_the_nanosecond) {
  EXPECT_EQ(utc_text(nanoseconds(0)), "1970-01-01T00:00:00.000000000Z");
  EXPECT_EQ(utc_text(nanoseconds(1'764'072'000'000'000'123)), "2025-11-25T12:00:00.000000123Z");
}

TEST(UtcText, is_read_again) {
  for (const std::int64_t ns : {0LL, 1'764'072'000'000'000'123LL})
    EXPECT_EQ(read_utc_text(utc_text(nanoseconds(ns))), nanoseconds(ns));
  EXPECT_EQ(read_utc_text("1970-01-01T00:00:02Z"), std::chrono::seconds(2));
  EXPECT_EQ(read_utc_text("1970-01-01T00:00:00.25Z"), std::chrono::milliseconds(250));
  for (const char* wrong : {"", "yesterday", "1970-01-01T00:00:02", "1970-01-01T00:00:02Zulu"})
    EXPECT_EQ(read_utc_text(wrong), std::nullopt) << wrong;
}

}  // namespace
}  // namespace roomcast
