// SPDX-License-Identifier: Apache-2.0
#include "bench/align/join_suite.h"

#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace roomcast::bench {
namespace {

TEST(JoinSuite, places_the_sensor_that_joins_and_times_it) {
  JoinSuiteOptions options;
  options.rooms = options.there = 1;
  options.frames = 1;
  options.sensing.half_color = true;
  options.sensing = options.sensing.clean();
  const auto rooms = run_join_suite(options, {});
  ASSERT_TRUE(rooms) << rooms.error().message;
  ASSERT_EQ(rooms->size(), 1U);
  EXPECT_TRUE(rooms->front().placed);
  EXPECT_GT(rooms->front().look_cpu_s, 0);
  EXPECT_GT(rooms->front().place_cpu_s, 0);
}

TEST(JoinSuite, prints_every_room) {
  JoinedRoom room;
  room.scene = "office";
  room.look_cpu_s = 0.5;
  room.place_cpu_s = 0.75;
  std::ostringstream json, table;
  print_json({room, room}, json);
  print_table({room}, table);
  EXPECT_EQ(nlohmann::json::parse(json.str())["rooms"][1]["place_cpu_s"], 0.75);
  EXPECT_NE(table.str().find("1.25 s"), std::string::npos);
}

}  // namespace
}  // namespace roomcast::bench
