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

}  // namespace
}  // namespace roomcast::client
