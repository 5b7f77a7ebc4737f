// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/page_policy.h"

#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast::net {
namespace {

using testing::HasSubstr;

TEST(PagePolicy, the_page_of_a_lone_hub_may_connect_to_its_own_server_only) {
  EXPECT_EQ(page_policy({}), kPagePolicy);
  EXPECT_THAT(page_policy({}), HasSubstr("connect-src 'self';"));
}

TEST(PagePolicy, a_page_may_connect_only_to_sockets_of_named_servers) {
  const std::array others = {*parse_hub_url("wss://B.example:7600/ws"),
                             *parse_hub_url("ws://[::1]:80")};
  EXPECT_THAT(page_policy(others),
              HasSubstr("connect-src 'self' wss://b.example:7600 ws://[::1]:80;"));
}

TEST(PagePolicy, only_named_sites_may_show_a_page_in_a_frame) {
  EXPECT_THAT(page_policy({}), testing::EndsWith("frame-ancestors 'none'"));
  const std::array sites = {std::string("https://a.example"), std::string("http://localhost:80")};
  EXPECT_THAT(page_policy({}, sites),
              testing::EndsWith("; frame-ancestors https://a.example http://localhost:80"));
}

TEST(PagePolicy, a_site_is_written_as_browsers_do) {
  EXPECT_EQ(site_of(*parse_hub_url("wss://B.example:7600/ws")), "https://b.example:7600");
  EXPECT_EQ(site_of(*parse_hub_url("wss://b.example")), "https://b.example");
  EXPECT_EQ(site_of(*parse_hub_url("ws://127.0.0.1:80")), "http://127.0.0.1");
  EXPECT_EQ(site_of(*parse_hub_url("wss://b.example:80")), "https://b.example:80");
}

}  // namespace
}  // namespace roomcast::net
