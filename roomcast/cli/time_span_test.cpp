// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/time_span.h"

#include <gtest/gtest.h>

namespace roomcast::cli {
namespace {

TEST(TimeSpan, accepts_seconds_minutes_hours_and_days) {
  EXPECT_EQ(*parse_time_span("90s"), 90);
  EXPECT_EQ(*parse_time_span("30m"), 1800);
  EXPECT_EQ(*parse_time_span("8h"), 28'800);
  EXPECT_EQ(*parse_time_span("7d"), 604'800);
}

TEST(TimeSpan, invalid_values_are_refused) {
  for (const char* text : {"", "8", "h", "8 h", "-1h", "0s", "8hh", "999999999999d", "1y"}) {
    EXPECT_FALSE(parse_time_span(text).ok()) << text;
  }
}

TEST(TimeSpan, is_written_in_the_largest_whole_unit) {
  EXPECT_EQ(format_time_span(90), "90s");
  EXPECT_EQ(format_time_span(3600), "1h");
  EXPECT_EQ(format_time_span(7200), "2h");
  EXPECT_EQ(format_time_span(604'800), "7d");
  EXPECT_EQ(format_time_span(0), "0s");
}

}  // namespace
}  // namespace roomcast::cli
