// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/credential.h"

#include <gtest/gtest.h>

namespace roomcast::client {
namespace {

TEST(Credential, distinguishes_a_code_from_a_token) {
  EXPECT_EQ(credential_of("7K2M-9QXA-0C4T-VW3H").code, "7K2M-9QXA-0C4T-VW3H");
  EXPECT_EQ(credential_of("eyJ.abc.def").token, "eyJ.abc.def");
}

TEST(Credential, an_empty_credential_sets_neither_token_nor_code) {
  wire::pb::Join join;
  show(credential_of(""), join);
  EXPECT_EQ(join.token(), "");
  EXPECT_EQ(join.code(), "");
}

TEST(Credential, a_file_without_a_token_is_named) {
  const auto credential = read_credential_file("/nowhere/token");
  EXPECT_EQ(credential.error().code, ErrorCode::kNotFound);
  EXPECT_NE(credential.error().message.find("/nowhere/token"), std::string::npos);
}

TEST(JoinCheck, takes_what_hubs_and_people_write) {
  EXPECT_TRUE(check_join("", "sensor", "", {}).ok());
  EXPECT_TRUE(check_join("lab", "sensor", "Küche links", {.token = "ey.J-_=.x", .code = {}}).ok());
}

TEST(JoinCheck, names_what_no_hub_could_read) {
  EXPECT_EQ(check_join("lab", "sensor", "\xff", {}).error().message,
            "the sensor's name is not valid UTF-8");
  EXPECT_FALSE(check_join("\xc3", "viewer", "a", {}).ok());
  EXPECT_FALSE(check_join(std::string(65, 'r'), "viewer", "a", {}).ok());
  EXPECT_FALSE(check_join("lab", "viewer", "a", {.token = "a.\xff.c", .code = {}}).ok());
  EXPECT_FALSE(check_join("lab", "viewer", "a", {.token = {}, .code = "a\tb"}).ok());
  EXPECT_FALSE(
      check_join("lab", "viewer", "a", {.token = std::string(1025, '.'), .code = {}}).ok());
}

}  // namespace
}  // namespace roomcast::client
