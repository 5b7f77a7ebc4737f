// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/store/token_store.h"

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::hub {
namespace {

namespace pb = wire::pb;

constexpr UnixSeconds kStoredNow = 1'800'000'000;

Claims stored_claims(const std::string& id, const std::string& room) {
  return {.id = id,
          .grant = {.room = room, .role = TokenRole::kSensor, .name = "left"},
          .issued_at = kStoredNow,
          .expires_at = kStoredNow + 60};
}

class TokenStoreTest : public testing::Test {
 protected:
  std::unique_ptr<Database> database = *Database::open(std::nullopt);
  TokenStore tokens{*database};
  const CodeDigest code = *digest_of_code("7K1M-90XA-0C4T-VW3H");
  const CodeGrant grant{.grant = {.room = "lab", .role = TokenRole::kViewer, .name = "Ada"},
                        .token_ttl = 600};
};

TEST_F(TokenStoreTest, lists_the_newest_first) {
  ASSERT_TRUE(tokens.add(stored_claims("a", "lab")).ok());
  ASSERT_TRUE(tokens.add(stored_claims("b", "kitchen")).ok());
  const auto all = *tokens.list(kAllRooms);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].claims.id, "b");
  EXPECT_EQ(all[1].claims.grant.role, TokenRole::kSensor);
  EXPECT_EQ(tokens.list("kitchen")->size(), 1U);
  EXPECT_TRUE(tokens.list("cellar")->empty());
}

TEST_F(TokenStoreTest, a_revoked_token_stays_revoked) {
  ASSERT_TRUE(tokens.add(stored_claims("a", "lab")).ok());
  EXPECT_FALSE(*tokens.is_revoked("a"));
  ASSERT_TRUE(tokens.revoke("a", kStoredNow).ok());
  ASSERT_TRUE(tokens.revoke("a", kStoredNow + 1).ok());
  EXPECT_TRUE(*tokens.is_revoked("a"));
  EXPECT_TRUE(tokens.find("a")->revoked);
  ASSERT_EQ(tokens.revoked(kStoredNow)->size(), 1u);
  EXPECT_EQ(tokens.revoked(kStoredNow)->front().id, "a");
  EXPECT_TRUE(tokens.revoked(kStoredNow + 60)->empty()) << "it has expired anyway";
}

TEST_F(TokenStoreTest, a_rooms_tokens_and_codes_are_revoked_together) {
  ASSERT_TRUE(tokens.add(stored_claims("a", "lab")).ok());
  ASSERT_TRUE(tokens.add(stored_claims("b", "kitchen")).ok());
  ASSERT_TRUE(tokens.add_code(code, grant, kStoredNow, kStoredNow + 60).ok());
  ASSERT_TRUE(tokens.revoke_all("lab", kStoredNow).ok());
  EXPECT_TRUE(*tokens.is_revoked("a"));
  EXPECT_FALSE(*tokens.is_revoked("b"));
  EXPECT_EQ(refusal(tokens.redeem(code, kStoredNow))->code, pb::ERROR_TOKEN_REVOKED);
}

TEST_F(TokenStoreTest, a_revocation_of_another_hub_applies_to_any_token) {
  ASSERT_TRUE(tokens.add(stored_claims("a", "lab")));
  for (const char* id : {"a", "elsewhere", "elsewhere"}) {
    ASSERT_TRUE(tokens.add_revoked(stored_claims(id, "lab"), kStoredNow));
    EXPECT_TRUE(*tokens.is_revoked(id));
  }
  EXPECT_EQ(tokens.revoked(kStoredNow)->size(), 2u);
}

TEST_F(TokenStoreTest, an_unknown_token_cannot_be_revoked) {
  EXPECT_EQ(tokens.revoke("unknown", kStoredNow).error().code, ErrorCode::kNotFound);
  EXPECT_EQ(tokens.find("unknown").error().code, ErrorCode::kNotFound);
}

TEST_F(TokenStoreTest, a_code_can_be_used_once) {
  ASSERT_TRUE(tokens.add_code(code, grant, kStoredNow, kStoredNow + 60).ok());
  const auto redeemed = tokens.redeem(code, kStoredNow);
  ASSERT_EQ(refusal(redeemed), nullptr);
  EXPECT_EQ(std::get<CodeGrant>(redeemed).grant.name, "Ada");
  EXPECT_EQ(std::get<CodeGrant>(redeemed).token_ttl, 600);
  EXPECT_EQ(refusal(tokens.redeem(code, kStoredNow))->code, pb::ERROR_CODE_USED);
}

TEST_F(TokenStoreTest, a_used_code_stays_used_after_a_restart) {
  const TemporaryFolder folder;
  {
    const auto before = *Database::open(folder / "hub.sqlite");
    TokenStore store(*before);
    ASSERT_TRUE(store.add_code(code, grant, kStoredNow, kStoredNow + 60).ok());
    ASSERT_EQ(refusal(store.redeem(code, kStoredNow)), nullptr);
  }
  const auto after = *Database::open(folder / "hub.sqlite");
  EXPECT_EQ(refusal(TokenStore(*after).redeem(code, kStoredNow))->code, pb::ERROR_CODE_USED);
}

TEST_F(TokenStoreTest, lists_a_code_until_its_token_replaces_it) {
  ASSERT_TRUE(tokens.add(stored_claims("a", "lab")).ok());
  ASSERT_TRUE(tokens.add_code(code, grant, kStoredNow + 1, kStoredNow + 60).ok());
  const auto listed = *tokens.list("lab");
  ASSERT_EQ(listed.size(), 2U);
  EXPECT_TRUE(listed[0].is_code);
  EXPECT_EQ(listed[0].claims.id, id_of_code(code));
  EXPECT_EQ(listed[0].claims.grant.name, "Ada");
  EXPECT_EQ(listed[0].claims.expires_at, kStoredNow + 60);
  EXPECT_FALSE(listed[1].is_code);
  ASSERT_EQ(refusal(tokens.redeem(code, kStoredNow + 2)), nullptr);
  EXPECT_EQ(tokens.list("lab")->size(), 1U);
  EXPECT_EQ(tokens.revoke(id_of_code(code), kStoredNow + 3).error().code, ErrorCode::kNotFound);
}

TEST_F(TokenStoreTest, a_revoked_code_is_refused) {
  const CodeDigest other = *digest_of_code("7K1M-90XA-0C4T-VW3J");
  ASSERT_TRUE(tokens.add_code(code, grant, kStoredNow, kStoredNow + 60).ok());
  ASSERT_TRUE(tokens.add_code(other, grant, kStoredNow, kStoredNow + 60).ok());
  EXPECT_EQ(tokens.find(id_of_code(code))->claims.grant.room, "lab");
  ASSERT_TRUE(tokens.revoke(id_of_code(code), kStoredNow).ok());
  EXPECT_TRUE(tokens.find(id_of_code(code))->revoked);
  EXPECT_EQ(refusal(tokens.redeem(code, kStoredNow))->code, pb::ERROR_TOKEN_REVOKED);
  EXPECT_EQ(refusal(tokens.redeem(other, kStoredNow)), nullptr);
  EXPECT_TRUE(tokens.revoked(kStoredNow)->empty()) << "no token was issued for it";
}

TEST_F(TokenStoreTest, a_code_expires) {
  ASSERT_TRUE(tokens.add_code(code, grant, kStoredNow, kStoredNow + 60).ok());
  EXPECT_EQ(refusal(tokens.redeem(code, kStoredNow + 60))->code, pb::ERROR_TOKEN_EXPIRED);
}

TEST_F(TokenStoreTest, an_unknown_code_is_refused) {
  EXPECT_EQ(refusal(tokens.redeem(code, kStoredNow))->code, pb::ERROR_TOKEN_INVALID);
}

TEST_F(TokenStoreTest, removes_tokens_that_expired_long_ago) {
  ASSERT_TRUE(tokens.add(stored_claims("a", "lab")).ok());
  ASSERT_TRUE(tokens.remove_expired(kStoredNow + 3600).ok());
  EXPECT_EQ(tokens.list(kAllRooms)->size(), 1U);
  ASSERT_TRUE(tokens.remove_expired(kStoredNow + 365 * 24 * 3600).ok());
  EXPECT_TRUE(tokens.list(kAllRooms)->empty());
}

TEST_F(TokenStoreTest, a_clock_that_was_far_ahead_makes_no_revoked_token_valid) {
  const UnixSeconds far_ahead = kStoredNow + 40LL * 365 * 24 * 3600;
  for (const char* id : {"a", "b"}) ASSERT_TRUE(tokens.add(stored_claims(id, id)).ok());
  ASSERT_TRUE(tokens.revoke("a", kStoredNow).ok());
  ASSERT_TRUE(tokens.revoke_all("b", far_ahead).ok());
  ASSERT_TRUE(tokens.remove_expired(far_ahead).ok());
  EXPECT_TRUE(*tokens.is_revoked("a"));
  EXPECT_TRUE(*tokens.is_revoked("b"));
}

}  // namespace
}  // namespace roomcast::hub
