// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/store/hub_store.h"

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::hub {
namespace {

namespace pb = wire::pb;

const Grant kViewer{.room = "lab", .role = TokenRole::kViewer, .name = "Ada"};

class HubStoreTest : public testing::Test {
 protected:
  std::unique_ptr<HubStore> open(std::optional<std::filesystem::path> path = std::nullopt) {
    auto opened = HubStore::open(path, [this] { return now; });
    EXPECT_TRUE(opened.ok());
    return *std::move(opened);
  }
  static pb::ErrorCode fault(const Verdict<Claims>& verdict) {
    const Refusal* why = refusal(verdict);
    return why == nullptr ? pb::ERROR_UNSPECIFIED : why->code;
  }

  UnixSeconds now = 1'800'000'000;
  const TemporaryFolder folder;
};

TEST_F(HubStoreTest, accepts_its_tokens_until_they_expire) {
  const auto store = open();
  const auto made = *store->issue(kViewer, 60);
  EXPECT_EQ(std::get<Claims>(store->check(made.token)).grant.name, "Ada");
  now += 60;
  EXPECT_EQ(fault(store->check(made.token)), pb::ERROR_TOKEN_EXPIRED);
}

TEST_F(HubStoreTest, tokens_and_revocations_survive_a_restart) {
  std::string kept, revoked;
  {
    const auto store = open(folder.path());
    kept = store->issue(kViewer, 60)->token;
    const auto made = *store->issue(kViewer, 60);
    revoked = made.token;
    ASSERT_TRUE(store->revoke(made.claims.id).ok());
  }
  const auto store = open(folder.path());
  EXPECT_EQ(fault(store->check(kept)), pb::ERROR_UNSPECIFIED);
  EXPECT_EQ(fault(store->check(revoked)), pb::ERROR_TOKEN_REVOKED);
  EXPECT_EQ(store->revoked()->size(), 1U);
}

TEST_F(HubStoreTest, a_revocation_of_another_hub_is_new_once) {
  const auto store = open();
  const auto made = *store->issue(kViewer, 60);
  const Claims elsewhere{.id = "t9", .grant = kViewer, .issued_at = now, .expires_at = now + 60};
  const Claims expired{.id = "t8", .grant = kViewer, .issued_at = now - 9, .expires_at = now};
  EXPECT_EQ(store->add_revoked({made.claims, elsewhere, expired})->size(), 2U);
  EXPECT_EQ(store->add_revoked({made.claims, elsewhere})->size(), 0U);
  EXPECT_EQ(fault(store->check(made.token)), pb::ERROR_TOKEN_REVOKED);
}

TEST_F(HubStoreTest, another_hubs_token_is_refused) {
  EXPECT_EQ(fault(open()->check(open()->issue(kViewer, 60)->token)), pb::ERROR_TOKEN_INVALID);
}

TEST_F(HubStoreTest, a_code_becomes_a_token_once) {
  const auto store = open();
  const auto made = *store->issue_code(kViewer, 600);
  const auto redeemed = store->redeem(made.code);
  ASSERT_EQ(refusal(redeemed), nullptr);
  const auto& token = std::get<NewToken>(redeemed);
  EXPECT_EQ(token.claims.expires_at, now + 600);
  EXPECT_EQ(fault(store->check(token.token)), pb::ERROR_UNSPECIFIED);
  EXPECT_EQ(refusal(store->redeem(made.code))->code, pb::ERROR_CODE_USED);
  EXPECT_EQ(refusal(store->redeem("nonsense"))->code, pb::ERROR_TOKEN_INVALID);
}

TEST_F(HubStoreTest, a_token_from_a_code_can_be_revoked_as_any) {
  const auto store = open();
  const auto redeemed = store->redeem(store->issue_code(kViewer, 600)->code);
  const auto& token = std::get<NewToken>(redeemed);
  ASSERT_TRUE(store->revoke(token.claims.id).ok());
  EXPECT_EQ(fault(store->check(token.token)), pb::ERROR_TOKEN_REVOKED);
}

TEST_F(HubStoreTest, detects_changes_of_another_program) {
  const auto hub = open(folder.path()), program = open(folder.path());
  (void)hub->changed_elsewhere();  // opening the second store changed the file
  EXPECT_FALSE(hub->changed_elsewhere());
  const auto made = *program->issue(kViewer, 60);
  EXPECT_TRUE(hub->changed_elsewhere());
  EXPECT_FALSE(hub->changed_elsewhere());
  EXPECT_EQ(fault(hub->check(made.token)), pb::ERROR_UNSPECIFIED);
}

TEST_F(HubStoreTest, the_hubs_own_token_is_not_listed) {
  const auto store = open();
  EXPECT_TRUE(covers(std::get<Claims>(store->check(store->sign_own())).grant, "any room"));
  EXPECT_TRUE(store->tokens(kAllRooms)->empty());
}

TEST_F(HubStoreTest, refuses_to_issue_invalid_tokens) {
  const auto store = open();
  EXPECT_FALSE(store->issue(kViewer, 0).ok());
  EXPECT_FALSE(store->issue(kViewer, HubStore::kMaxTtl + 1).ok());
  EXPECT_FALSE(store->issue({.room = "*", .role = TokenRole::kViewer}, 60).ok());
  EXPECT_FALSE(store->issue({.room = "", .role = TokenRole::kAdmin}, 60).ok());
  EXPECT_FALSE(store->issue({.room = std::string(65, 'x'), .role = TokenRole::kAdmin}, 60).ok());
  EXPECT_FALSE(store->issue_code({.room = "*", .role = TokenRole::kSensor}, 60).ok());
  EXPECT_TRUE(store->issue({.room = "*", .role = TokenRole::kAdmin}, 60).ok());
}

}  // namespace
}  // namespace roomcast::hub
