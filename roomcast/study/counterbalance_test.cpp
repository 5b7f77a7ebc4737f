// SPDX-License-Identifier: Apache-2.0
#include "roomcast/study/counterbalance.h"

#include <algorithm>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast::study {
namespace {

using testing::ElementsAre;

TEST(Counterbalance, every_condition_is_at_every_place_and_after_every_other_equally_often) {
  for (const std::size_t n : {2u, 3u, 4u, 5u, 6u, 7u, 12u}) {
    const std::size_t square = participants_per_square(n, ConditionOrder::kBalanced);
    EXPECT_EQ(square, n % 2 == 0 ? n : 2 * n);
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> at_place, follows;
    for (std::size_t participant = 0; participant < square; ++participant) {
      const auto order = order_for(participant, n, ConditionOrder::kBalanced, "s");
      EXPECT_EQ(std::set(order.begin(), order.end()).size(), n);
      for (std::size_t i = 0; i < n; ++i) {
        ++at_place[{i, order[i]}];
        if (i > 0) ++follows[{order[i - 1], order[i]}];
      }
    }
    EXPECT_EQ(at_place.size(), n * n);
    EXPECT_EQ(follows.size(), n * (n - 1));
    for (const auto& [place, count] : at_place) EXPECT_EQ(count, square / n) << n;
    for (const auto& [pair, count] : follows) EXPECT_EQ(count, square / n) << n;
  }
}

TEST(Counterbalance, the_square_repeats) {
  EXPECT_EQ(order_for(1, 4, ConditionOrder::kBalanced, "s"),
            order_for(5, 4, ConditionOrder::kBalanced, "s"));
  EXPECT_THAT(order_for(0, 4, ConditionOrder::kBalanced, "s"), ElementsAre(0, 1, 3, 2));
}

TEST(Counterbalance, a_fixed_order_is_that_of_the_plan) {
  for (std::size_t participant = 0; participant < 5; ++participant)
    EXPECT_THAT(order_for(participant, 3, ConditionOrder::kFixed, "s"), ElementsAre(0, 1, 2));
}

TEST(Counterbalance, a_random_order_is_the_same_each_time_and_not_for_each_participant) {
  std::set<std::vector<std::size_t>> orders;
  for (std::size_t participant = 0; participant < 100; ++participant) {
    const auto order = order_for(participant, 3, ConditionOrder::kRandom, "s");
    EXPECT_EQ(order, order_for(participant, 3, ConditionOrder::kRandom, "s"));
    orders.insert(order);
  }
  EXPECT_EQ(orders.size(), 6u);
}

TEST(Counterbalance, one_condition_or_none_has_one_order) {
  EXPECT_TRUE(order_for(7, 0, ConditionOrder::kBalanced, "s").empty());
  EXPECT_THAT(order_for(7, 1, ConditionOrder::kBalanced, "s"), ElementsAre(0));
}

}  // namespace
}  // namespace roomcast::study
