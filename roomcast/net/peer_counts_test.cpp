// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/peer_counts.h"

#include <gtest/gtest.h>

namespace roomcast::net {
namespace {

TEST(PeerCounts, the_limit_applies_to_each_address_separately) {
  PeerCounts counts;
  const auto first = counts.enter("10.0.0.1", 2), second = counts.enter("10.0.0.1", 2);
  EXPECT_NE(second, nullptr);
  EXPECT_EQ(counts.enter("10.0.0.1", 2), nullptr);
  EXPECT_NE(counts.enter("10.0.0.2", 2), nullptr);
}

TEST(PeerCounts, a_place_that_is_left_is_free) {
  PeerCounts counts;
  auto place = counts.enter("10.0.0.1", 1);
  place.reset();
  EXPECT_NE(counts.enter("10.0.0.1", 1), nullptr);
}

TEST(PeerCounts, a_place_may_outlive_the_counts) {
  auto counts = std::make_unique<PeerCounts>();
  const auto place = counts->enter("10.0.0.1", 1);
  counts.reset();
  EXPECT_NE(place, nullptr);
}

TEST(PeerCounts, addresses_that_went_are_forgotten_and_those_that_stay_are_not) {
  PeerCounts counts;
  const auto stays = counts.enter("here", 1);
  for (int i = 0; i < 5000; ++i) EXPECT_NE(counts.enter(std::to_string(i), 1), nullptr);
  EXPECT_EQ(counts.enter("here", 1), nullptr);
}

}  // namespace
}  // namespace roomcast::net
