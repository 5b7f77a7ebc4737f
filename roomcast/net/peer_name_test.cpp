// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/peer_name.h"

#include <gtest/gtest.h>

namespace roomcast::net {
namespace {

std::string name_of(const char* address) {
  return peer_name(boost::asio::ip::make_address(address));
}

TEST(PeerName, an_ipv4_address_has_one_name_in_every_notation) {
  EXPECT_EQ(name_of("192.0.2.7"), "192.0.2.7");
  EXPECT_EQ(name_of("::ffff:192.0.2.7"), "192.0.2.7");
}

TEST(PeerName, machines_of_one_ipv6_network_are_one) {
  EXPECT_EQ(name_of("2001:db8:1:2:3:4:5:6"), name_of("2001:db8:1:2:ffff::1"));
  EXPECT_NE(name_of("2001:db8:1:2::1"), name_of("2001:db8:1:3::1"));
}

TEST(PeerName, loopback_is_loopback) {
  EXPECT_EQ(name_of("::1"), "::1");
  EXPECT_EQ(name_of("127.0.0.1"), "127.0.0.1");
}

TEST(PeerName, is_read_from_an_address_or_from_itself) {
  EXPECT_EQ(parse_peer_name("192.0.2.7"), "192.0.2.7");
  EXPECT_EQ(parse_peer_name("2001:db8:1:2:3::4"), "2001:db8:1:2::/64");
  EXPECT_EQ(parse_peer_name("2001:db8:1:2::/64"), "2001:db8:1:2::/64");
  for (const char* text :
       {"", "proxy.example.org", "192.0.2.7:80", "192.0.2.0/24", "10.0.0.0/64"}) {
    EXPECT_EQ(parse_peer_name(text), std::nullopt) << text;
  }
}

TEST(PeerName, a_socket_that_has_gone_has_none) {
  boost::asio::io_context io;
  EXPECT_EQ(peer_name(boost::asio::ip::tcp::socket(io)), "");
}

}  // namespace
}  // namespace roomcast::net
