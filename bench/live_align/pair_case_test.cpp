// SPDX-License-Identifier: Apache-2.0
#include "bench/live_align/pair_case.h"

#include <sstream>

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

TEST(PairCase, an_exact_pose_has_no_error_and_a_shifted_one_has_its_shift_until_it_is_refined) {
  const auto room = simulator::SimulatedRoom::build("bare", 1).value();
  auto sensors = sensors_apart(room, 1, 90).value();
  const auto still = still_views(sensors);
  ASSERT_TRUE(still.ok()) << still.error().message;
  auto found = case_of("bare", 1, sensors);
  EXPECT_GT(found.apart_deg, 45);
  RigidTransform a_from_b =
      sensors.first.world_from_depth().inverse() * sensors.second.world_from_depth();
  place(sensors, {a_from_b, 30}, found);
  EXPECT_NEAR(found.error_mm, 0, 1e-6);
  a_from_b.translation_m.x() += 0.03;
  place(sensors, {a_from_b, 30}, found);
  EXPECT_NEAR(found.error_mm, 30, 1e-6);
  EXPECT_EQ(found.found_error_mm, found.error_mm);
  place_refined(sensors, *still, {a_from_b, 30}, found);
  EXPECT_NEAR(found.found_error_mm, 30, 1e-6);
  EXPECT_LT(found.error_mm, 25) << "refined";
  std::ostringstream table, json;
  print_table({found}, table);
  print_json({found}, json);
  EXPECT_NE(table.str().find("30.0 mm"), std::string::npos);
  EXPECT_NE(json.str().find("worst_error_mm"), std::string::npos);
}

TEST(RunRooms, skips_rooms_without_a_walking_person_and_stops_at_other_errors) {
  const auto progress = [](std::string_view) {};
  const auto odd_ones = [](const char*, std::uint64_t seed) -> Result<PairCase> {
    if (seed % 2 == 0) return Error{ErrorCode::kInvalidArgument, "no walking person"};
    PairCase one;
    one.seed = seed;
    return one;
  };
  const auto cases = run_rooms(3, 4, odd_ones, progress);
  ASSERT_TRUE(cases.ok());
  ASSERT_EQ(cases->size(), 3U);
  EXPECT_EQ(cases->back().seed, 9U);
  const auto broken = [](const char*, std::uint64_t) -> Result<PairCase> {
    return Error{ErrorCode::kUnavailable, "broken"};
  };
  EXPECT_FALSE(run_rooms(3, 4, broken, progress).ok());
  const auto empty = [](const char*, std::uint64_t) -> Result<PairCase> {
    return Error{ErrorCode::kInvalidArgument, "no walking person"};
  };
  EXPECT_FALSE(run_rooms(3, 4, empty, progress).ok()) << "it gives up";
}

}  // namespace
}  // namespace roomcast::bench
