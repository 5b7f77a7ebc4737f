// SPDX-License-Identifier: Apache-2.0
#include "roomcast/foxglove/subscriptions.h"

#include <gtest/gtest.h>

namespace roomcast::foxglove {
namespace {

TopicMessagePtr message(std::string bytes) {
  return std::make_shared<const TopicMessage>(TopicMessage{nanoseconds(0), std::move(bytes)});
}

constexpr ChannelId kDepth{1}, kPoints{2};

TEST(FoxgloveSubscriptions, give_a_topic_under_the_clients_id) {
  Subscriptions subscriptions;
  ASSERT_TRUE(subscriptions.add({40, kDepth}).ok());
  EXPECT_FALSE(subscriptions.next().has_value());
  subscriptions.offer(kDepth, message("a"));
  subscriptions.offer(kPoints, message("nobody asked"));
  const auto next = subscriptions.next();
  ASSERT_TRUE(next.has_value());
  EXPECT_EQ(next->subscription, 40u);
  EXPECT_EQ(next->message->bytes, "a");
  EXPECT_FALSE(subscriptions.next().has_value());
}

TEST(FoxgloveSubscriptions, a_newer_message_replaces_an_older_one) {
  Subscriptions subscriptions;
  ASSERT_TRUE(subscriptions.add({1, kDepth}).ok());
  for (const char* bytes : {"a", "b", "c"}) subscriptions.offer(kDepth, message(bytes));
  EXPECT_EQ(subscriptions.next()->message->bytes, "c");
  EXPECT_EQ(subscriptions.skipped(), 2u);
}

TEST(FoxgloveSubscriptions, no_topic_starves_another) {
  Subscriptions subscriptions;
  ASSERT_TRUE(subscriptions.add({1, kDepth}).ok());
  ASSERT_TRUE(subscriptions.add({2, kPoints}).ok());
  subscriptions.offer(kPoints, message("p"));
  subscriptions.offer(kDepth, message("d"));
  subscriptions.offer(kPoints, message("q"));  // keeps its turn
  EXPECT_EQ(subscriptions.next()->message->bytes, "q");
  subscriptions.offer(kPoints, message("r"));
  EXPECT_EQ(subscriptions.next()->message->bytes, "d");
  EXPECT_EQ(subscriptions.next()->message->bytes, "r");
}

TEST(FoxgloveSubscriptions, ids_and_channels_are_used_once) {
  Subscriptions subscriptions;
  ASSERT_TRUE(subscriptions.add({1, kDepth}).ok());
  EXPECT_FALSE(subscriptions.add({1, kPoints}).ok());
  EXPECT_FALSE(subscriptions.add({2, kDepth}).ok());
  EXPECT_TRUE(subscriptions.remove(1));
  EXPECT_FALSE(subscriptions.remove(1));
  EXPECT_TRUE(subscriptions.add({1, kPoints}).ok());
  EXPECT_EQ(subscriptions.channels(), std::vector<ChannelId>{kPoints});
  subscriptions.drop(kPoints);
  EXPECT_TRUE(subscriptions.channels().empty());
}

}  // namespace
}  // namespace roomcast::foxglove
