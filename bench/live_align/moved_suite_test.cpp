// SPDX-License-Identifier: Apache-2.0
#include "bench/live_align/moved_suite.h"

#include <sstream>

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

TEST(MovedSuite, pushes_are_detected_in_time_and_people_are_no_alarm) {
  MovedSuiteOptions options;
  options.minutes = 0.2;
  options.pushes = 1;
  options.scenes = {"livingroom"};
  const auto rows = run_moved_suite(options, [](std::string_view) {});
  ASSERT_TRUE(rows.ok()) << rows.error().message;
  ASSERT_EQ(rows->size(), 1U);
  const MovedRow& row = rows->front();
  EXPECT_EQ(row.checks, 30);
  EXPECT_EQ(row.alarms, 0);
  EXPECT_EQ(row.two_cm.noticed, 1);
  EXPECT_EQ(row.half_degree.noticed, 1);
  EXPECT_LT(row.two_cm.longest_s, 2);
  std::ostringstream table;
  print_table(*rows, table);
  EXPECT_NE(table.str().find("livingroom"), std::string::npos);
}

TEST(MovedSuite, an_unknown_scene_is_refused) {
  MovedSuiteOptions options;
  options.scenes = {"cellar"};
  EXPECT_FALSE(run_moved_suite(options, [](std::string_view) {}));
}

}  // namespace
}  // namespace roomcast::bench
