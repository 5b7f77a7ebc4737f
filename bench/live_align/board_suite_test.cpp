// SPDX-License-Identifier: Apache-2.0
#include "bench/live_align/board_suite.h"

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

TEST(BoardSuite, a_carried_board_places_a_sensor_about_as_well_as_expected) {
  BoardSuiteOptions options;
  options.rooms = 1;
  options.seconds = 60;
  const auto cases = run_board_suite(options, [](std::string_view) {});
  ASSERT_TRUE(cases.ok()) << cases.error().message;
  ASSERT_EQ(cases->size(), 1U);
  const PairCase& one = cases->front();
  ASSERT_TRUE(one.placed) << one.reason;
  EXPECT_LT(one.error_mm, 4 * one.expected_error_mm);
}

}  // namespace
}  // namespace roomcast::bench
