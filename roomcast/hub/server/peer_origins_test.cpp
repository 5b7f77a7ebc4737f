// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/server/peer_origins.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(PeerOrigins, keep_the_origins_of_hubs_that_are_gone) {
  PeerOrigins sites;
  sites.add({"wss://b:7600", "no address:"});
  sites.add({"wss://c:7600"});
  EXPECT_TRUE(sites.has("https://b:7600"));
  EXPECT_TRUE(sites.has("https://c:7600"));
  EXPECT_FALSE(sites.has("http://c:7600")) << "not without encryption";
  EXPECT_FALSE(sites.has("https://c:7601"));
  EXPECT_FALSE(sites.has(""));
  EXPECT_THAT(sites.policy(), HasSubstr("connect-src 'self' wss://b:7600 wss://c:7600;"));
}

TEST(PeerOrigins, are_limited_in_number) {
  PeerOrigins sites;
  for (std::size_t i = 0; i <= PeerOrigins::kMax; ++i) {
    sites.add({"ws://h" + std::to_string(i) + ":7600"});
  }
  EXPECT_FALSE(sites.has("http://h0:7600"));
  EXPECT_TRUE(sites.has("http://h1:7600"));
  EXPECT_THAT(sites.policy(), Not(HasSubstr("ws://h0:")));
}

}  // namespace
}  // namespace roomcast::hub
