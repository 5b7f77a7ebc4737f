// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/cluster/revoked_tokens.h"

#include <gtest/gtest.h>

namespace roomcast::hub::federation {
namespace {

TEST(RevokedTokens, are_read_as_written) {
  const hub::Claims sent{.id = "t1",
                         .grant = {.room = "lab", .role = hub::TokenRole::kSensor, .name = "left"},
                         .issued_at = 10,
                         .expires_at = 20};
  const auto came = revoked_tokens(revoked_message({sent}));
  ASSERT_EQ(came.size(), 1u);
  EXPECT_EQ(came[0].id, "t1");
  EXPECT_EQ(came[0].grant.room, "lab");
  EXPECT_EQ(came[0].grant.role, hub::TokenRole::kSensor);
  EXPECT_EQ(came[0].grant.name, "left");
  EXPECT_EQ(came[0].issued_at, 10);
  EXPECT_EQ(came[0].expires_at, 20);
}

TEST(RevokedTokens, leave_out_invalid_entries) {
  const hub::Claims good{.id = "t1", .grant = {.room = "lab"}};
  pb::Revoked message = revoked_message({good, good, good, good, good});
  message.mutable_tokens(0)->clear_id();
  message.mutable_tokens(1)->set_role("king");
  message.mutable_tokens(2)->set_room(std::string(1000, 'x'));
  message.mutable_tokens(3)->set_id(std::string(1000, 'x'));
  EXPECT_EQ(revoked_tokens(message).size(), 1u);
}

}  // namespace
}  // namespace roomcast::hub::federation
