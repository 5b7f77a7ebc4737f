// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/access/wall_clock.h"

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

TEST(WallClock, is_after_2025_and_increases) {
  constexpr UnixSeconds kBefore = 1'750'000'000;
  const UnixSeconds first = wall_time();
  EXPECT_GT(first, kBefore);
  EXPECT_GE(wall_time(), first);
}

}  // namespace
}  // namespace roomcast::hub
