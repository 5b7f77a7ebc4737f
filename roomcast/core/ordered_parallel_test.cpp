// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/ordered_parallel.h"

#include <atomic>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace roomcast {
namespace {

TEST(OrderedParallel, every_task_is_done_once_and_handed_on_in_order) {
  for (const int threads : {1, 2, 7}) {
    std::vector<std::atomic<int>> worked(100);
    std::vector<int> handed_on;
    const Status status = run_in_order(
        100, threads,
        [&](int thread, int task) {
          EXPECT_LT(thread, threads);
          ++worked[static_cast<std::size_t>(task)];
          return Status();
        },
        [&](int task) {
          EXPECT_EQ(worked[static_cast<std::size_t>(task)], 1);
          handed_on.push_back(task);
          return Status();
        });
    EXPECT_TRUE(status);
    std::vector<int> all(100);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(handed_on, all);
  }
}

TEST(OrderedParallel, threads_do_not_run_far_ahead) {
  std::atomic<int> started = 0;
  const Status status = run_in_order(
      200, 2,
      [&](int, int) {
        ++started;
        return Status();
      },
      [&](int task) {
        EXPECT_LE(started, task + 1 + 6);
        return Status();
      });
  EXPECT_TRUE(status);
}

TEST(OrderedParallel, a_failure_ends_it_with_that_failure) {
  std::atomic<int> started = 0;
  int handed_on = 0;
  const Status status = run_in_order(
      1000, 3,
      [&](int, int task) {
        ++started;
        if (task == 20) return Status(Error{ErrorCode::kUnavailable, "the disk is full"});
        return Status();
      },
      [&](int) {
        ++handed_on;
        return Status();
      });
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().message, "the disk is full");
  EXPECT_LE(handed_on, 20);
  EXPECT_LT(started, 40);
  const Status refused = run_in_order(
      5, 2, [](int, int) { return Status(); },
      [](int task) {
        return task < 2 ? Status() : Error{ErrorCode::kClosed, "stopped"};
      });
  EXPECT_EQ(refused.error().message, "stopped");
}

TEST(OrderedParallel, no_tasks_are_done_at_once) {
  const auto never = [](auto...) -> Status { return Error{}; };
  EXPECT_TRUE(run_in_order(0, 2, never, never));
}

}  // namespace
}  // namespace roomcast
