// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/runtime/revoked_message.h"

#include <gtest/gtest.h>

#include "roomcast/wire/control_check.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub {
namespace {

namespace pb = wire::pb;

Claims token(const std::string& id, const std::string& room, TokenRole role = TokenRole::kViewer) {
  return {.id = id,
          .grant = {.room = room, .role = role, .name = "Ada"},
          .issued_at = 100,
          .expires_at = 200};
}

TEST(RevokedMessage, lists_the_rooms_revoked_tokens_without_their_owners) {
  const auto messages = revoked_messages(
      {token("a", "lab"), token("b", "another"), token("c", "*", TokenRole::kAdmin)}, "lab");
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_TRUE(wire::check_control(messages[0]).ok());
  EXPECT_EQ(messages[0].SerializeAsString().find("Ada"), std::string::npos);
  const auto claims = revoked_claims(messages[0].revoked_tokens(), "lab");
  ASSERT_EQ(claims.size(), 2u);
  EXPECT_EQ(claims[0].id, "a");
  EXPECT_EQ(claims[0].expires_at, 200);
  EXPECT_EQ(claims[1].id, "c");
  EXPECT_EQ(claims[1].grant.role, TokenRole::kAdmin);
}

TEST(RevokedMessage, is_absent_without_revoked_tokens) {
  EXPECT_TRUE(revoked_messages({token("b", "another")}, "lab").empty());
}

TEST(RevokedMessage, many_tokens_need_several_messages) {
  const std::vector<Claims> many(wire::kMaxRevokedTokens + 1, token("a", "lab"));
  const auto messages = revoked_messages(many, "lab");
  ASSERT_EQ(messages.size(), 2u);
  EXPECT_EQ(messages[1].revoked_tokens().tokens_size(), 1);
}

TEST(RevokedMessage, ignores_tokens_of_other_rooms_or_unknown_roles) {
  pb::RevokedTokens message;
  message.add_tokens()->set_room("another");
  message.mutable_tokens(0)->set_role("viewer");
  message.add_tokens()->set_room("lab");
  message.mutable_tokens(1)->set_role("king");
  message.add_tokens()->set_room("*");
  message.mutable_tokens(2)->set_role("viewer");
  EXPECT_TRUE(revoked_claims(message, "lab").empty());
}

}  // namespace
}  // namespace roomcast::hub
