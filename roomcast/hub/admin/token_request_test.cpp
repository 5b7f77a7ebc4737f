// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/admin/token_request.h"

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

using Json = nlohmann::json;

std::string request_fault(const Json& json) {
  const auto request = read_token_request(json);
  return request ? "" : request.error().message;
}

TEST(TokenRequest, has_room_role_name_and_duration) {
  const auto request = read_token_request(
      {{"room", "lab"}, {"role", "sensor"}, {"name", "left"}, {"ttl_s", 60}, {"once", true}});
  ASSERT_TRUE(request.ok());
  EXPECT_EQ(request->grant.role, TokenRole::kSensor);
  EXPECT_EQ(request->ttl, 60);
  EXPECT_TRUE(request->once);
  EXPECT_EQ(read_token_request({{"room", "a"}, {"role", "viewer"}})->ttl, TokenRequest::kTtl);
}

TEST(TokenRequest, names_the_wrong_field) {
  EXPECT_NE(request_fault({{"room", "lab"}}), "");
  EXPECT_NE(request_fault({{"role", "viewer"}}), "");
  EXPECT_NE(request_fault({{"room", "lab"}, {"role", "king"}}).find("role"), std::string::npos);
  EXPECT_NE(request_fault({{"room", "lab"}, {"role", "viewer"}, {"ttl_s", "x"}}).find("ttl_s"),
            std::string::npos);
  EXPECT_NE(request_fault({{"room", "lab"}, {"role", "viewer"}, {"colour", 1}}).find("colour"),
            std::string::npos);
}

TEST(TokenRequest, becomes_a_token_or_a_code_with_a_link) {
  const auto store = *HubStore::open(std::nullopt);
  const auto token = make_token_for({.grant = {.room = "my lab"}}, *store);
  EXPECT_EQ(refusal(store->check((*token)["token"])), nullptr);
  const auto code = make_token_for({.grant = {.room = "my lab"}, .once = true}, *store);
  EXPECT_EQ((*code)["fragment"], "#room=my%20lab&code=" + (*code)["code"].get<std::string>());
  EXPECT_EQ(refusal(store->redeem((*code)["code"])), nullptr);
  EXPECT_FALSE(make_token_for({.grant = {.room = ""}}, *store).ok());
}

}  // namespace
}  // namespace roomcast::hub
