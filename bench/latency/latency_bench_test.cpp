// SPDX-License-Identifier: Apache-2.0
#include "bench/latency/latency_bench.h"

#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "bench/latency/latency_cases.h"

namespace roomcast::bench {
namespace {

using namespace std::chrono_literals;

TEST(LatencyBench, a_viewer_behind_a_narrow_link_gets_whole_sets) {
  LatencyReport report;
  const auto status = measure_narrow(1s, report);
  if (!status && status.error().code == ErrorCode::kUnsupported) {
    GTEST_SKIP() << status.error().message;
  }
  ASSERT_TRUE(status.ok()) << status.error().message;
  for (const LatencyRow& row : report.rows) EXPECT_GT(row.p50, 0) << row.name;
  for (const Figure& figure : report.figures) {
    if (figure.name == "narrow: partial sets") {
      EXPECT_EQ(figure.value, 0);
    }
    if (figure.name == "narrow: sets delivered") {
      EXPECT_LT(figure.value, 70);
    }
  }
}

TEST(LatencyBench, audio_passes_a_line_that_frames_fill) {
  LatencyReport report;
  const auto status = measure_voice(1s, report);
  if (!status && status.error().code == ErrorCode::kUnsupported) {
    GTEST_SKIP() << status.error().message;
  }
  ASSERT_TRUE(status.ok()) << status.error().message;
  ASSERT_EQ(report.rows.size(), 1U);
  EXPECT_GT(report.rows[0].p50, 25) << "the link's own delay";
  for (const Figure& figure : report.figures) {
    if (figure.name == "voice: audio packets delivered") {
      EXPECT_GT(figure.value, 80);
    }
    if (figure.name == "voice: frames delivered") {
      EXPECT_LT(figure.value, 95) << "else the line is not full";
    }
  }
}

TEST(LatencyBench, distributions_are_ordered) {
  const LatencyRow row = distribution("x", "ms", {5, 1, 4, 2, 3});
  EXPECT_EQ(row.p50, 3);
  EXPECT_LE(row.p50, row.p95);
  EXPECT_LE(row.p95, row.p99);
  EXPECT_EQ(distribution("nothing", "ms", {}).p99, 0);
}

TEST(LatencyBench, json_has_the_keys_that_scripts_rely_on) {
  LatencyReport report;
  report.rows.push_back({"room: decoded", "ms", 1, 2, 3});
  report.figures.push_back({"narrow: use of the link", "%", 96});
  std::ostringstream out;
  print_json(report, out);
  const auto json = nlohmann::json::parse(out.str());
  EXPECT_EQ(json["rows"][0]["p99"], 3);
  EXPECT_EQ(json["figures"][0]["value"], 96);
}

}  // namespace
}  // namespace roomcast::bench
