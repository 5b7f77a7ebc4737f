// SPDX-License-Identifier: Apache-2.0
#include "bench/redundancy/redundancy_bench.h"

#include <sstream>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/simulator/rig/simulate_rig.h"

namespace roomcast::bench {
namespace {

class RedundancyBenchTest : public testing::Test {
 protected:
  Result<RedundancyReport> run(int sensors) {
    simulator::SimulateRigOptions options;
    options.sensor_count = sensors;
    options.seconds = 0.3;
    options.fps = 15;
    options.views = 0;
    const auto rig = folder / "rig";
    EXPECT_TRUE(simulator::simulate_rig(rig, options).ok());
    const auto description = recording::read_rig_json(rig / "rig.json");
    EXPECT_TRUE(description.ok());
    RedundancyOptions few;
    few.frames = 6;
    return run_redundancy_bench(rig, *description, few, {});
  }
  const TemporaryFolder folder;
};

TEST_F(RedundancyBenchTest, sensors_around_a_room_show_some_of_it_better_than_others) {
  const auto report = run(2);
  ASSERT_TRUE(report.ok()) << report.error().message;
  ASSERT_EQ(report->sensors.size(), 2U);
  EXPECT_EQ(report->frames, 6U);
  for (const SensorRedundancy& sensor : report->sensors) {
    EXPECT_GT(sensor.better_share, 0);
    EXPECT_LT(sensor.better_share, 0.9);
    EXPECT_GT(sensor.bytes, 1000);
    EXPECT_GT(sensor.frozen_bytes, 1000);
    EXPECT_GT(sensor.left_out_bytes, 1000);
  }
  std::ostringstream table;
  print_table(*report, table);
  EXPECT_NE(table.str().find("s1"), std::string::npos);
}

TEST_F(RedundancyBenchTest, it_takes_two_sensors) {
  const auto report = run(1);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().code, ErrorCode::kInvalidArgument);
}

}  // namespace
}  // namespace roomcast::bench
