// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/allowed_names.h"

#include <gtest/gtest.h>

namespace roomcast::net {
namespace {

const AllowedNames kNames{
    .any_host = false, .hosts = {"hub.example.org"}, .origins = {"https://rooms.example.org"}};

TEST(AllowedNames, addresses_localhost_and_own_names_are_accepted) {
  for (const char* host : {"127.0.0.1:7600", "[::1]:7600", "192.0.2.7", "localhost:7600",
                           "LocalHost", "hub.example.org", "HUB.example.org:443"}) {
    EXPECT_TRUE(kNames.allows_host(host)) << host;
  }
}

TEST(AllowedNames, a_rebound_name_is_refused) {
  for (const char* host : {"evil.example", "evil.example:7600", "", "127.0.0.1.evil.example",
                           "hub.example.org.evil.example", "["}) {
    EXPECT_FALSE(kNames.allows_host(host)) << host;
  }
}

TEST(AllowedNames, with_a_certificate_every_name_is_accepted) {
  EXPECT_TRUE(AllowedNames{.any_host = true}.allows_host("whatever.example"));
}

TEST(AllowedNames, who_says_nothing_allows_addresses_only) {
  EXPECT_FALSE(AllowedNames{}.allows_host("evil.example:7700"));
  EXPECT_TRUE(AllowedNames{}.allows_host("127.0.0.1:7700"));
}

TEST(AllowedNames, pages_of_this_server_and_of_named_sites_may_connect) {
  EXPECT_TRUE(kNames.allows_origin("http://127.0.0.1:7600", "127.0.0.1:7600"));
  EXPECT_TRUE(kNames.allows_origin("https://rooms.example.org", "127.0.0.1:7600"));
  EXPECT_FALSE(kNames.allows_origin("https://evil.example", "127.0.0.1:7600"));
  EXPECT_FALSE(kNames.allows_origin("null", "127.0.0.1:7600"));
}

}  // namespace
}  // namespace roomcast::net
