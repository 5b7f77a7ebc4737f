// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/server/process_stats.h"

#include <vector>

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

TEST(ProcessStats, count_the_processor_time) {
  const double before_s = process_stats().cpu_s;
  volatile unsigned counted = 0;
  while (process_stats().cpu_s < before_s + 0.01) counted = counted + 1;
  EXPECT_GT(process_stats().cpu_s, before_s);
}

TEST(ProcessStats, count_the_memory_in_use) {
  constexpr std::size_t kBytes = 64U << 20U;
  const auto before = process_stats().resident_bytes;
  const std::vector<char> memory(kBytes, 'x');
  EXPECT_GE(process_stats().resident_bytes, before + memory.size() * 9 / 10);
}

}  // namespace
}  // namespace roomcast::hub
