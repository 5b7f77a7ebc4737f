// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/qr_code.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace roomcast::cli {
namespace {

TEST(QrCode, a_link_becomes_a_square_of_half_characters) {
  const auto drawn = qr_code_for_terminal("https://hub.example.org:7600/#room=lab&code=7K2M");
  ASSERT_TRUE(drawn.ok());
  // 29 squares a side (version 3) and a quiet zone of 2 all around, two squares a line.
  EXPECT_EQ(std::ranges::count(*drawn, '\n'), 17);
  EXPECT_NE(drawn->find("█"), std::string::npos);
}

TEST(QrCode, text_too_long_for_a_code_is_refused) {
  EXPECT_EQ(qr_code_for_terminal(std::string(5000, 'x')).error().code, ErrorCode::kTooLarge);
}

}  // namespace
}  // namespace roomcast::cli
