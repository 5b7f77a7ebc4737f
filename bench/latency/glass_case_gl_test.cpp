// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <cstdio>

#include <gtest/gtest.h>

#include "bench/latency/latency_cases.h"

namespace roomcast::bench {
namespace {

TEST(GlassCase, reads_the_time_of_capture_from_the_window) {
  LatencyReport report;
  const Status status = measure_glass(std::chrono::seconds(4), report);
  ASSERT_TRUE(status.ok()) << status.error().message;
  ASSERT_EQ(report.rows.size(), 1U);
  EXPECT_GT(report.rows[0].p50, 0);
  EXPECT_LT(report.rows[0].p50, 30'000) << "the time of another picture";
  std::printf("glass: window: p50 %.0f ms, p95 %.0f ms\n", report.rows[0].p50, report.rows[0].p95);
}

}  // namespace
}  // namespace roomcast::bench
