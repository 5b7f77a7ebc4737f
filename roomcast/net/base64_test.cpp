// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/base64.h"

#include <string_view>

#include <gtest/gtest.h>

namespace roomcast::net {
namespace {

std::string base64_of(std::string_view text) {
  return base64({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

TEST(Base64, is_that_of_the_rfc) {
  EXPECT_EQ(base64_of(""), "");
  EXPECT_EQ(base64_of("f"), "Zg==");
  EXPECT_EQ(base64_of("fo"), "Zm8=");
  EXPECT_EQ(base64_of("foo"), "Zm9v");
  EXPECT_EQ(base64_of("\xff\xfe\xfd\xfc"), "//79/A==");
}

}  // namespace
}  // namespace roomcast::net
