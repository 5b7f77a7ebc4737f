// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/csv_field.h"

#include <gtest/gtest.h>

namespace roomcast {
namespace {

TEST(CsvField, is_quoted_where_needed_and_no_formula) {
  EXPECT_EQ(csv_field("plain"), "plain");
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("two\nlines"), "\"two\nlines\"");
  EXPECT_EQ(csv_field("=1+1"), "\"'=1+1\"");
  EXPECT_EQ(csv_field(""), "");
}

TEST(CsvField, can_be_quoted_always) {
  EXPECT_EQ(quoted_csv_field("plain"), "\"plain\"");
  EXPECT_EQ(quoted_csv_field("say \"a\""), "\"say \"\"a\"\"\"");
  EXPECT_EQ(quoted_csv_field("=1+1"), "\"'=1+1\"");
}

}  // namespace
}  // namespace roomcast
