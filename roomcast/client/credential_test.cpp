// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/credential.h"

#include <gtest/gtest.h>

namespace roomcast {
namespace {

TEST(Credential, a_code_is_told_from_a_token) {
  EXPECT_EQ(credential_of("7K2M-9QXA-0C4T-VW3H").code, "7K2M-9QXA-0C4T-VW3H");
  EXPECT_EQ(credential_of("eyJ.abc.def").token, "eyJ.abc.def");
}

TEST(Credential, nothing_shows_nothing) {
  wire::pb::Join join;
  show(credential_of(""), join);
  EXPECT_EQ(join.token(), "");
  EXPECT_EQ(join.code(), "");
}

}  // namespace
}  // namespace roomcast
