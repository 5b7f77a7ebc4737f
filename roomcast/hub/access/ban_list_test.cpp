// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/access/ban_list.h"

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

using namespace std::chrono_literals;

constexpr HostTime host_time(std::chrono::seconds time) {
  return HostTime(1h + time);
}

TEST(BanList, a_few_faults_do_not_ban) {
  BanList bans({.faults = 3});
  EXPECT_FALSE(bans.fault("a", host_time(0s)));
  EXPECT_FALSE(bans.fault("a", host_time(1s)));
  EXPECT_FALSE(bans.is_banned("a", host_time(1s)));
}

TEST(BanList, too_many_faults_ban_only_their_address) {
  BanList bans({.faults = 3, .ban = 300s});
  bans.fault("a", host_time(0s));
  bans.fault("a", host_time(1s));
  EXPECT_TRUE(bans.fault("a", host_time(2s)));
  EXPECT_TRUE(bans.is_banned("a", host_time(301s)));
  EXPECT_FALSE(bans.is_banned("b", host_time(3s)));
  EXPECT_FALSE(bans.is_banned("a", host_time(302s)));
  EXPECT_EQ(bans.banned_count(host_time(3s)), 1U);
}

TEST(BanList, old_faults_do_not_count) {
  BanList bans({.faults = 2, .within = 60s});
  bans.fault("a", host_time(0s));
  EXPECT_FALSE(bans.fault("a", host_time(61s)));
}

TEST(BanList, faults_after_a_ban_ban_again) {
  BanList bans({.faults = 2, .within = 60s, .ban = 10s});
  bans.fault("a", host_time(0s));
  EXPECT_TRUE(bans.fault("a", host_time(1s)));
  EXPECT_FALSE(bans.fault("a", host_time(20s)));
  EXPECT_TRUE(bans.fault("a", host_time(21s)));
}

TEST(BanList, drops_older_records_beyond_its_limit) {
  BanList bans({.faults = 2, .max_peers = 100});
  for (int i = 0; i < 1000; ++i) EXPECT_FALSE(bans.fault(std::to_string(i), host_time(0s)));
  EXPECT_FALSE(bans.fault("0", host_time(1s))) << "its first fault was forgotten";
}

TEST(BanList, bans_no_address_without_rules) {
  BanList bans({.faults = 0});
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(bans.fault("a", host_time(0s)));
}

}  // namespace
}  // namespace roomcast::hub
