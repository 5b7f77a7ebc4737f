// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/own_addresses.h"

#include <boost/asio/ip/address.hpp>
#include <gtest/gtest.h>

namespace roomcast::net {
namespace {

TEST(OwnAddresses, can_be_used_from_other_machines) {
  for (const bool with_ipv6 : {false, true}) {
    for (const std::string& text : own_addresses(with_ipv6)) {
      const auto address = boost::asio::ip::make_address(text);
      EXPECT_FALSE(address.is_loopback()) << text;
      EXPECT_FALSE(address.is_unspecified()) << text;
      EXPECT_TRUE(with_ipv6 || address.is_v4()) << text;
    }
  }
}

}  // namespace
}  // namespace roomcast::net
