// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/connection_peak.h"

#include <gtest/gtest.h>

namespace roomcast::net {
namespace {

TEST(ConnectionPeak, few_connections_leave_nothing_to_give_back) {
  ConnectionPeak peak;
  EXPECT_FALSE(peak.has_fallen(255));
  EXPECT_FALSE(peak.is_high());
  EXPECT_FALSE(peak.has_fallen(0));
}

TEST(ConnectionPeak, has_fallen_once_after_a_flood) {
  ConnectionPeak peak;
  EXPECT_FALSE(peak.has_fallen(4000));
  EXPECT_TRUE(peak.is_high());
  EXPECT_FALSE(peak.has_fallen(2001));
  EXPECT_TRUE(peak.has_fallen(100));
  EXPECT_FALSE(peak.is_high());
  EXPECT_FALSE(peak.has_fallen(0));
}

TEST(ConnectionPeak, falls_again_after_those_who_stay) {
  ConnectionPeak peak;
  EXPECT_FALSE(peak.has_fallen(4000));
  EXPECT_TRUE(peak.has_fallen(600));
  EXPECT_TRUE(peak.is_high());
  EXPECT_FALSE(peak.has_fallen(301));
  EXPECT_TRUE(peak.has_fallen(300));
}

}  // namespace
}  // namespace roomcast::net
