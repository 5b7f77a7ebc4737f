// SPDX-License-Identifier: Apache-2.0
#include "bench/live_align/person_suite.h"

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

TEST(PersonSuite, a_sensor_is_placed_about_as_well_as_expected_or_refused_with_a_reason) {
  PersonSuiteOptions options;
  options.rooms = 1;
  const auto cases = run_person_suite(options, [](std::string_view) {});
  ASSERT_TRUE(cases.ok()) << cases.error().message;
  ASSERT_EQ(cases->size(), 1U);
  const PairCase& one = cases->front();
  EXPECT_GT(one.apart_deg, 90);
  if (one.placed) {
    EXPECT_LT(one.error_mm, 4 * one.expected_error_mm);
  } else {
    EXPECT_FALSE(one.reason.empty());
  }
}

}  // namespace
}  // namespace roomcast::bench
