// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/admin/download_links.h"

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

using namespace std::chrono_literals;

const DownloadLinks::File kFile{.scope = {.room = "lab"}, .name = "one"};

TEST(DownloadLinks, are_valid_once_and_for_a_minute) {
  DownloadLinks links;
  const HostTime now{1h};
  const std::string key = links.make(kFile, now), other = links.make(kFile, now);
  EXPECT_EQ(key.size(), 32u);
  EXPECT_NE(key, other);
  EXPECT_FALSE(links.take("", now));
  const auto file = links.take(key, now + 59s);
  ASSERT_TRUE(file);
  EXPECT_EQ(file->name, "one");
  EXPECT_EQ(file->scope.room, "lab");
  EXPECT_FALSE(links.take(key, now + 59s));
  EXPECT_FALSE(links.take(other, now + DownloadLinks::kValid));
}

TEST(DownloadLinks, are_of_a_limited_number) {
  DownloadLinks links;
  const HostTime now{1h};
  const std::string oldest = links.make(kFile, now);
  std::string newest;
  for (std::size_t i = 0; i < DownloadLinks::kMaxLinks; ++i) newest = links.make(kFile, now);
  EXPECT_FALSE(links.take(oldest, now));
  EXPECT_TRUE(links.take(newest, now));
}

}  // namespace
}  // namespace roomcast::hub
