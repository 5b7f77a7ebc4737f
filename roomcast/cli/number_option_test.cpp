// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/number_option.h"

#include <gtest/gtest.h>

namespace roomcast::cli {
namespace {

TEST(NumberOption, what_is_within_is_taken) {
  for (const char* text : {"0", "1", "0.5", "1e-3"}) EXPECT_EQ(within(0.0, 1.0)(text), "") << text;
  EXPECT_EQ(within(1, 8)("8"), "");
}

TEST(NumberOption, nan_and_what_is_outside_is_refused_in_few_words) {
  for (const char* text : {"nan", "-nan", "inf", "-inf", "1e400", "-0.1", "1.01", "", "one"}) {
    const std::string why = within(0.0, 1.0)(text);
    EXPECT_NE(why.find("is not a number from 0 to 1"), std::string::npos) << text << ": " << why;
  }
  EXPECT_NE(within(1, 8)("2.5"), "");
  EXPECT_NE(within(1, 8)("99999999999999999999"), "");
  EXPECT_EQ(seconds_from_zero()("-1"), "-1 is not a number from 0 to 1e+09");
  EXPECT_NE(some_seconds()("0"), "");
}

TEST(NumberOption, a_seed_is_taken_as_it_is_or_refused) {
  EXPECT_EQ(seed_number()("0"), "");
  EXPECT_EQ(seed_number()("18446744073709551615"), "");
  for (const char* text :
       {"-1", "18446744073709551616", "999999999999999999999", "1.5", "0x10", ""})
    EXPECT_NE(seed_number()(text), "") << text;
}

}  // namespace
}  // namespace roomcast::cli
