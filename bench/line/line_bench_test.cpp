// SPDX-License-Identifier: Apache-2.0
#include "bench/line/line_bench.h"

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace roomcast::bench {
namespace {

using namespace std::chrono_literals;

double figure(const LineReport& report, const std::string& name, const std::string& unit) {
  const auto found = std::ranges::find_if(
      report.figures, [&](const Figure& f) { return f.name == name && f.unit == unit; });
  if (found == report.figures.end()) {
    ADD_FAILURE() << "there is no " << name << ", " << unit;
    return 0;
  }
  return found->value;
}

TEST(LineBench, sensors_that_nobody_watches_send_next_to_nothing) {
  LineReport report;
  const auto status = measure_unwatched(
      {.scene = "bare", .sensors = 1, .duration = 2s, .first_viewers = 1}, {}, report);
  ASSERT_TRUE(status.ok()) << status.error().message;
  EXPECT_GT(figure(report, "unwatched: bytes, watched", "kB/s"), 1);
  EXPECT_LT(figure(report, "unwatched: bytes", "% of watched"), 3);
  EXPECT_LT(figure(report, "unwatched: CPU", "% of watched"), 60);
}

TEST(LineBench, a_viewer_gets_fewer_bytes_of_what_he_does_not_look_at) {
  LineReport report;
  const auto status = measure_looking({.scene = "bare", .sensors = 2, .duration = 8s}, {}, report);
  ASSERT_TRUE(status.ok()) << status.error().message;
  EXPECT_GT(figure(report, "looking: bytes of all frames", "kB/s"), 1);
  EXPECT_LT(figure(report, "looking: bytes", "% of all"), 110);
  EXPECT_GT(figure(report, "looking: PSNR", "dB"), 10);
  EXPECT_GT(figure(report, "looking: PSNR", "dB"),
            figure(report, "looking: PSNR with all frames", "dB") - 1);
}

TEST(LineBench, a_sensor_keeps_to_its_target_rate) {
  LineReport report;
  const auto status = measure_rate(
      {.scene = "bare", .sensors = 1, .duration = 4s, .target_mbit = {0.5}, .rate_warm_up = 6s}, {},
      report);
  if (!status && status.error().code == ErrorCode::kUnsupported)
    GTEST_SKIP() << status.error().message;
  ASSERT_TRUE(status.ok()) << status.error().message;
  const double mean = figure(report, "rate 0.5 Mbit/s: mean", "Mbit/s");
  EXPECT_LT(mean, 0.53);
  EXPECT_GT(mean, 0.1) << "on a busy machine frames are missed";
  EXPECT_LT(figure(report, "rate 0.5 Mbit/s: highest 0.2 s", "% off"), 60)
      << "a busy machine delivers in bursts";
}

TEST(LineBench, a_sensor_follows_its_line) {
  LineReport report;
  const auto status = measure_auto({.scene = "bare",
                                    .sensors = 1,
                                    .duration = 5s,
                                    .link_mbit = {1.5, 0.5, 1.5},
                                    .rate_warm_up = 6s},
                                   {}, report);
  if (!status && status.error().code == ErrorCode::kUnsupported)
    GTEST_SKIP() << status.error().message;
  ASSERT_TRUE(status.ok()) << status.error().message;
  EXPECT_GT(figure(report, "auto: share of the link", "%"), 20) << "a bare room has little to say";
  EXPECT_GT(figure(report, "auto, 2. 0.5 Mbit/s: share of the link", "%"), 30);
  EXPECT_GT(figure(report, "auto, 2. 0.5 Mbit/s: frames of a sensor", "1/s"), 2);
  EXPECT_LT(figure(report, "auto: age on arrival, p50", "ms"), 1'000) << "on a busy machine";
}

TEST(LineBench, a_sensor_that_comes_later_gets_a_part_of_the_line) {
  LineReport report;
  const auto status =
      measure_late({.scene = "bare", .duration = 2s, .rate_warm_up = 3s}, {}, report);
  if (!status && status.error().code == ErrorCode::kUnsupported)
    GTEST_SKIP() << status.error().message;
  ASSERT_TRUE(status.ok()) << status.error().message;
  EXPECT_GT(figure(report, "late, 4. part: share of the one who came later", "%"), 10);
  EXPECT_GT(figure(report, "late, 4. part: share of the link", "%"), 5) << "a bare room";
  EXPECT_LT(figure(report, "late, 4. part: age on arrival, p95", "ms"), 2'000) << "a busy machine";
}

TEST(LineBench, json_has_the_keys_that_scripts_rely_on) {
  std::ostringstream out;
  print_json({.figures = {{"unwatched: CPU", "cores", 0.25}}}, out);
  const auto json = nlohmann::json::parse(out.str());
  EXPECT_EQ(json["figures"][0]["name"], "unwatched: CPU");
  EXPECT_EQ(json["figures"][0]["value"], 0.25);
}

}  // namespace
}  // namespace roomcast::bench
