// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/server/peer_origins.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(PeerOrigins, are_remembered_when_they_are_gone) {
  PeerOrigins sites;
  sites.are({"wss://b:7600", "no address:"});
  sites.are({"wss://c:7600"});
  EXPECT_TRUE(sites.has("https://b:7600"));
  EXPECT_TRUE(sites.has("https://c:7600"));
  EXPECT_FALSE(sites.has("http://c:7600")) << "not without encryption";
  EXPECT_FALSE(sites.has("https://c:7601"));
  EXPECT_FALSE(sites.has(""));
  EXPECT_THAT(sites.policy(), HasSubstr("connect-src 'self' wss://b:7600 wss://c:7600;"));
}

TEST(PeerOrigins, are_so_many_and_no_more) {
  PeerOrigins sites;
  for (std::size_t i = 0; i <= PeerOrigins::kMax; ++i) {
    sites.are({"ws://h" + std::to_string(i) + ":7600"});
  }
  EXPECT_FALSE(sites.has("http://h0:7600"));
  EXPECT_TRUE(sites.has("http://h1:7600"));
  EXPECT_THAT(sites.policy(), Not(HasSubstr("ws://h0:")));
}

}  // namespace
}  // namespace roomcast::hub
