// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/runtime/embed_sites.h"

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

using Sites = std::vector<std::string>;

TEST(EmbedSites, are_those_of_one_room_until_they_are_withdrawn) {
  EmbedSites sites;
  sites.set("lab", {"https://a.example"});
  sites.set("hall", {"https://b.example"});
  EXPECT_EQ(sites.of("lab"), Sites{"https://a.example"});
  EXPECT_EQ(sites.of("none"), Sites{});
  sites.set("lab", {});
  EXPECT_EQ(sites.of("lab"), Sites{});
  EXPECT_EQ(sites.of("hall"), Sites{"https://b.example"});
}

}  // namespace
}  // namespace roomcast::hub
