// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/listen_address.h"

#include <gtest/gtest.h>

namespace roomcast::net {
namespace {

TEST(ListenAddress, both_kinds_of_addresses_are_read) {
  const auto v4 = parse_listen_address("127.0.0.1:7600");
  ASSERT_TRUE(v4.ok());
  EXPECT_EQ(v4->address, "127.0.0.1");
  EXPECT_EQ(v4->port, 7600);
  EXPECT_TRUE(v4->loopback);
  const auto v6 = parse_listen_address("[::1]:0");
  ASSERT_TRUE(v6.ok());
  EXPECT_EQ(v6->address, "::1");
  EXPECT_TRUE(v6->loopback);
  EXPECT_FALSE(parse_listen_address("0.0.0.0:7600")->loopback);
}

TEST(ListenAddress, invalid_addresses_are_refused) {
  for (const char* text : {"", "7600", "127.0.0.1", "127.0.0.1:", "127.0.0.1:x", "127.0.0.1:70000",
                           "127.0.0.1:-1", "localhost:7600", ":7600", "127.0.0.1:76 00"}) {
    const auto address = parse_listen_address(text);
    ASSERT_FALSE(address.ok()) << text;
    EXPECT_EQ(address.error().code, ErrorCode::kInvalidArgument);
  }
}

}  // namespace
}  // namespace roomcast::net
