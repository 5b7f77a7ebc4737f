// SPDX-License-Identifier: Apache-2.0
#include "bench/abuse/abuse_bench.h"

#include <sstream>

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

TEST(AbuseBench, measures_every_attack) {
  const auto rows = run_abuse_bench({.viewers = 2,
                                     .rounds = 1,
                                     .connections = 20,
                                     .bad_tokens = 20,
                                     .duration = std::chrono::milliseconds(200)});
  ASSERT_TRUE(rows.ok()) << rows.error().message;
  ASSERT_EQ(rows->size(), 4U);
  for (const AbuseRow& row : *rows) {
    EXPECT_GT(row.p99_quiet_ms, 0) << row.attack;
    EXPECT_GT(row.p99_beside_ms, 0) << row.attack;
    EXPECT_GT(row.p99_ms, 0) << row.attack;
    EXPECT_GT(row.p99_ratio_beside, 0) << row.attack;
    EXPECT_GT(row.tried, 0U) << row.attack;
    EXPECT_GT(row.rss_most_mb, 0) << row.attack;
  }
  std::ostringstream table, json;
  print_table(*rows, table);
  print_json(*rows, json);
  EXPECT_NE(table.str().find("slowloris"), std::string::npos);
  EXPECT_NE(json.str().find("\"p99_ratio\""), std::string::npos);
}

}  // namespace
}  // namespace roomcast::bench
