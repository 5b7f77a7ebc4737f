// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/open_connections.h"

#include <memory>

#include <gtest/gtest.h>

namespace roomcast::net {
namespace {

TEST(OpenConnections, counts_leases_that_are_held) {
  const auto connections = std::make_shared<OpenConnections>();
  auto first = connections->open();
  const auto second = connections->open();
  EXPECT_EQ(connections->count(), 2U);
  first.reset();
  EXPECT_EQ(connections->count(), 1U);
}

TEST(OpenConnections, ends_each_one_even_when_that_gives_its_lease_back) {
  const auto connections = std::make_shared<OpenConnections>();
  auto first = connections->open();
  auto second = connections->open();
  const auto third = connections->open();  // has no `end` function
  int ended = 0;
  first->end_with([&] { ++ended, first.reset(); });
  second->end_with([&] { ++ended, second.reset(); });
  connections->end_all();
  EXPECT_EQ(ended, 2);
  EXPECT_EQ(connections->count(), 1U);
}

TEST(OpenConnections, ends_those_that_come_after_all_were_ended) {
  const auto connections = std::make_shared<OpenConnections>();
  connections->end_all();
  auto late = connections->open();
  late->end_with([&] { late.reset(); });
  EXPECT_EQ(connections->count(), 0U);
}

TEST(OpenConnections, a_lease_may_outlive_everyone_else) {
  auto connections = std::make_shared<OpenConnections>();
  const auto lease = connections->open();
  connections.reset();
  lease->end_with({});
}

}  // namespace
}  // namespace roomcast::net
