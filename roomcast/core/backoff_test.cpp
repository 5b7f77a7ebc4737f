// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/backoff.h"

#include <gtest/gtest.h>

namespace roomcast {
namespace {

using namespace std::chrono_literals;

TEST(Backoff, doubles_up_to_a_few_seconds) {
  Backoff pace(1);
  for (const auto longest : {250ms, 500ms, 1000ms, 2000ms, 4000ms, 4000ms, 4000ms}) {
    const auto pause = pace.next();
    EXPECT_LE(pause, longest);
    EXPECT_GE(pause, longest * 3 / 4);
  }
}

TEST(Backoff, begins_again_after_a_success) {
  Backoff pace(1);
  for (int i = 0; i < 10; ++i) (void)pace.next();
  pace.succeeded();
  EXPECT_LE(pace.next(), 250ms);
}

TEST(Backoff, clients_do_not_come_back_all_at_once) {
  Backoff one(1), other(2);
  EXPECT_GT(std::chrono::abs(one.next() - other.next()), 1ms);
}

}  // namespace
}  // namespace roomcast
