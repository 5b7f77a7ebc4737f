// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <stop_token>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/core/blocking_queue.h"
#include "roomcast/core/drop_oldest_queue.h"
#include "roomcast/core/latest_mailbox.h"

namespace roomcast {
namespace {

TEST(LatestMailbox, a_newer_item_replaces_the_one_not_taken) {
  LatestMailbox<int> mailbox;
  EXPECT_FALSE(mailbox.put(1));
  EXPECT_EQ(mailbox.put(2), 1);
  EXPECT_EQ(mailbox.try_take(), 2);
  EXPECT_FALSE(mailbox.try_take());
  EXPECT_EQ(mailbox.dropped_count(), 1u);
}

TEST(LatestMailbox, take_waits_for_the_other_thread) {
  LatestMailbox<std::unique_ptr<int>> mailbox;
  std::jthread producer([&] { mailbox.put(std::make_unique<int>(5)); });
  EXPECT_EQ(**mailbox.take({}), 5);
}

TEST(LatestMailbox, a_stop_ends_the_wait) {
  LatestMailbox<int> mailbox;
  std::stop_source stop;
  std::jthread stopper([&] { stop.request_stop(); });
  EXPECT_FALSE(mailbox.take(stop.get_token()));
}

TEST(DropOldestQueue, keeps_the_newest_in_order) {
  DropOldestQueue<int> queue(2);
  queue.push(1);
  queue.push(2);
  EXPECT_EQ(queue.push(3), 1);
  EXPECT_EQ(queue.try_pop(), 2);
  EXPECT_EQ(queue.pop({}), 3);
  EXPECT_FALSE(queue.try_pop());
  EXPECT_EQ(queue.dropped_count(), 1u);
}

TEST(BlockingQueue, loses_nothing_and_keeps_the_order) {
  BlockingQueue<int> queue(3);
  std::jthread producer([&](std::stop_token stop) {
    for (int i = 0; i < 1000; ++i) ASSERT_TRUE(queue.push(i, stop));
    queue.close();
  });
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(queue.pop({}), i);
  EXPECT_FALSE(queue.pop({}));
}

TEST(BlockingQueue, a_full_queue_lets_the_producer_go_when_stopped) {
  BlockingQueue<int> queue(1);
  ASSERT_TRUE(queue.push(1, {}));
  std::stop_source stop;
  std::jthread stopper([&] { stop.request_stop(); });
  EXPECT_FALSE(queue.push(2, stop.get_token()));
}

TEST(BlockingQueue, a_closed_queue_takes_no_more) {
  BlockingQueue<int> queue(2);
  queue.close();
  EXPECT_FALSE(queue.push(1, {}));
}

}  // namespace
}  // namespace roomcast
