// SPDX-License-Identifier: Apache-2.0
#include "bench/live_align/pair_case.h"

#include <sstream>

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

TEST(PairCase, an_exact_pose_has_no_error_and_a_shifted_one_has_its_shift) {
  const auto room = SimulatedRoom::build("bare", 1).value();
  const auto sensors = sensors_apart(room, 1, 90).value();
  auto found = case_of("bare", 1, sensors);
  EXPECT_GT(found.apart_deg, 45);
  RigidTransform a_from_b =
      sensors.first.world_from_depth().inverse() * sensors.second.world_from_depth();
  place(sensors, a_from_b, 5, found);
  EXPECT_NEAR(found.error_mm, 0, 1e-6);
  a_from_b.translation_m.x() += 0.03;
  place(sensors, a_from_b, 5, found);
  EXPECT_NEAR(found.error_mm, 30, 1e-6);
  std::ostringstream table, json;
  print_table({found}, table);
  print_json({found}, json);
  EXPECT_NE(table.str().find("30.0 mm"), std::string::npos);
  EXPECT_NE(json.str().find("worst_error_mm"), std::string::npos);
}

}  // namespace
}  // namespace roomcast::bench
