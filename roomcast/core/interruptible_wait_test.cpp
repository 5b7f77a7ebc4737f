// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/interruptible_wait.h"

#include <thread>

#include <gtest/gtest.h>

namespace roomcast {
namespace {

using namespace std::chrono_literals;

TEST(InterruptibleWait, ends_when_its_time_has_come) {
  const HostTime due = SteadyClock().now() + 2ms;
  EXPECT_TRUE(wait_until(due, {}));
  EXPECT_GE(SteadyClock().now(), due);
  EXPECT_TRUE(wait_for(0ms, {}));
}

TEST(InterruptibleWait, ends_at_once_on_a_stop_request) {
  bool waited_to_the_end = true;
  {
    std::jthread waits(
        [&](const std::stop_token& stop) { waited_to_the_end = wait_for(1h, stop); });
  }  // requests the stop and joins the thread
  EXPECT_FALSE(waited_to_the_end);
}

TEST(InterruptibleWait, does_not_begin_after_a_stop_request) {
  std::stop_source asked;
  asked.request_stop();
  EXPECT_FALSE(wait_for(1h, asked.get_token()));
}

}  // namespace
}  // namespace roomcast
