// SPDX-License-Identifier: Apache-2.0
#include "bench/fanout/child_process.h"

#include <gtest/gtest.h>
#include <unistd.h>

namespace roomcast::bench {
namespace {

using namespace std::chrono_literals;

TEST(ChildProcess, reports_its_port_and_the_time_it_takes) {
  const auto child = ChildProcess::fork_off([](const ChildProcess::PortReport& report) {
    report(4711);
    for (;;) (void)::getpid();
  });
  ASSERT_TRUE(child.ok()) << child.error().message;
  EXPECT_EQ(child->port(), 4711);
  EXPECT_GT(child->resident_bytes(), 0U);
  const auto give_up = std::chrono::steady_clock::now() + 10s;
  while (child->cpu_time() < 5ms && std::chrono::steady_clock::now() < give_up) ::usleep(1000);
  EXPECT_GE(child->cpu_time(), 5ms);
}

TEST(ChildProcess, that_ends_at_once_is_an_error) {
  EXPECT_FALSE(ChildProcess::fork_off([](const ChildProcess::PortReport&) {}).ok());
}

TEST(ChildProcess, finds_programs_by_name) {
  EXPECT_FALSE(find_program("sh").empty());
  EXPECT_TRUE(find_program("no-such-program-anywhere").empty());
}

}  // namespace
}  // namespace roomcast::bench
