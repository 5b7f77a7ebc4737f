// SPDX-License-Identifier: Apache-2.0
#include "bench/fanout/fanout_bench.h"

#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace roomcast::bench {
namespace {

FanoutBenchOptions brief(const std::string& only) {
  FanoutBenchOptions options;
  options.viewers = {3};
  options.rounds = 1;
  options.loads = {"max", "stall"};
  options.duration = std::chrono::milliseconds(100);
  options.only = {only};
  return options;
}

TEST(FanoutBench, hub_and_limit_deliver_under_every_load) {
  for (const std::string engine : {"roomcast hub", "epoll"}) {
    const auto report = run_fanout_bench(brief(engine));
    ASSERT_TRUE(report.ok()) << report.error().message;
    ASSERT_EQ(report->rows.size(), 4U);  // two loads, each plain and with TLS
    for (const FanoutRow& row : report->rows) {
      EXPECT_GT(row.deliveries_per_cpu_s, 0) << row.engine << " " << row.load;
      EXPECT_GT(row.p99_ms, 0) << row.engine << " " << row.load;
      EXPECT_GE(row.p99_ms, row.p50_ms);
    }
  }
}

TEST(FanoutBench, an_unavailable_transport_is_reported) {
  const auto report = run_fanout_bench(brief("no such engine"));
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().code, ErrorCode::kInvalidArgument);
}

TEST(FanoutBench, json_has_the_keys_that_scripts_rely_on) {
  FanoutReport report;
  report.rows.push_back({.engine = "x", .load = "max", .viewers = 3});
  std::ostringstream out;
  print_json(report, out);
  const auto row = nlohmann::json::parse(out.str())["rows"][0];
  for (const char* key : {"engine", "viewers", "tls", "deliveries_per_cpu_s", "cores",
                          "ratio_to_limit", "p50_ms", "p99_ms", "rss_per_viewer_kb"}) {
    EXPECT_TRUE(row.contains(key)) << key;
  }
}

}  // namespace
}  // namespace roomcast::bench
