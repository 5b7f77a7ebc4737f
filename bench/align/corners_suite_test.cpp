// SPDX-License-Identifier: Apache-2.0
#include "bench/align/corners_suite.h"

#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace roomcast::bench {
namespace {

TEST(CornersSuite, sensors_without_flaws_are_placed_to_a_centimetre) {
  CornersSuiteOptions options;
  options.rooms = 1;
  options.frames = 1;
  options.sensing.half_color = true;
  options.sensing = options.sensing.clean();
  const auto rooms = run_corners_suite(options, {});
  ASSERT_TRUE(rooms) << rooms.error().message;
  ASSERT_EQ(rooms->size(), 1U);
  EXPECT_EQ(rooms->front().placed, 4U);
  EXPECT_LT(rooms->front().error.from_all_mm, 10);
  EXPECT_LT(rooms->front().error.from_all_deg, 0.1);
}

TEST(CornersSuite, prints_every_room) {
  CornersRoom room;
  room.seed = 7;
  room.sensors = 4;
  room.placed = 3;
  room.error.from_all_mm = 12.5;
  std::ostringstream json, table;
  print_json({room, room}, json);
  print_table({room, room}, table);
  const auto read = nlohmann::json::parse(json.str());
  EXPECT_EQ(read["rooms"].size(), 2U);
  EXPECT_EQ(read["rooms"][1]["from_all_mm"], 12.5);
  EXPECT_NE(table.str().find("3 of 4"), std::string::npos);
}

}  // namespace
}  // namespace roomcast::bench
