// SPDX-License-Identifier: Apache-2.0
#include "bench/model/moved_furniture.h"

#include <sstream>

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

// How soon it is forgotten depends on the computer's speed, which is what the bench is for.
TEST(MovedFurniture, what_is_moved_was_in_the_model) {
  MovedFurnitureOptions options;
  options.sensors = 1;
  options.fps = 4;
  options.stretch_s = 15;
  options.moves = 1;
  const auto report = run_moved_furniture(options, [](const std::string&) {});
  ASSERT_TRUE(report.ok()) << report.error().message;
  if (report->moves.empty()) GTEST_SKIP() << "this computer was too slow for a model in time";
  EXPECT_GT(report->moves[0].points, 100U);
  EXPECT_GT(report->triangles, 1000U);
  std::ostringstream table;
  print_table(*report, table);
  EXPECT_NE(table.str().find("points of the cabinet"), std::string::npos);
}

TEST(MovedFurniture, an_unknown_scene_is_named) {
  MovedFurnitureOptions options;
  options.scene = "moon";
  const auto report = run_moved_furniture(options, [](const std::string&) {});
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().code, ErrorCode::kNotFound);
}

}  // namespace
}  // namespace roomcast::bench
