// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/utc_text.h"

#include <gtest/gtest.h>

namespace roomcast {
namespace {

TEST(UtcText, is_iso_8601_to_the_nanosecond) {
  EXPECT_EQ(utc_text(nanoseconds(0)), "1970-01-01T00:00:00.000000000Z");
  EXPECT_EQ(utc_text(nanoseconds(1'764'072'000'000'000'123)), "2025-11-25T12:00:00.000000123Z");
}

}  // namespace
}  // namespace roomcast
