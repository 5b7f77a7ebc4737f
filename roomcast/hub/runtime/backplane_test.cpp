// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/runtime/backplane.h"

#include <gtest/gtest.h>

#include "roomcast/hub/runtime/shard.h"

namespace roomcast::hub {
namespace {

TEST(Backplane, a_connection_of_its_own_knows_its_owner) {
  const ConnectionId connection = backplane_connection(7, 3);
  EXPECT_TRUE(is_of_backplane(connection));
  EXPECT_EQ(backplane_owner(connection), 7u);
  EXPECT_NE(connection, backplane_connection(7, 4));
  EXPECT_NE(connection, backplane_connection(8, 3));
}

TEST(Backplane, a_shards_connection_is_not_one) {
  EXPECT_FALSE(is_of_backplane(ConnectionId{std::uint64_t{1} << 62}));
}

}  // namespace
}  // namespace roomcast::hub
