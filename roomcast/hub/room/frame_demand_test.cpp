// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/frame_demand.h"

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

using namespace std::chrono_literals;

constexpr RoomTime kStart{1h};

TEST(FrameDemand, NobodyHasWatchedYet) {
  FrameDemand demand;
  EXPECT_FALSE(demand.update(false, kStart));
  EXPECT_FALSE(demand.wanted());
  EXPECT_EQ(demand.next(), std::nullopt);
}

TEST(FrameDemand, BeginsWithTheFirstViewer) {
  FrameDemand demand;
  EXPECT_TRUE(demand.update(true, kStart));
  EXPECT_TRUE(demand.wanted());
  EXPECT_FALSE(demand.update(true, kStart + 1s)) << "a second viewer changes nothing";
  EXPECT_EQ(demand.next(), std::nullopt);
}

TEST(FrameDemand, EndsSomeSecondsAfterTheLastViewer) {
  FrameDemand demand;
  demand.update(true, kStart);
  EXPECT_FALSE(demand.update(false, kStart + 10s));
  EXPECT_TRUE(demand.wanted());
  EXPECT_EQ(demand.next(), kStart + 10s + FrameDemand::kKeptUnwatched);
  EXPECT_FALSE(demand.update(false, *demand.next() - 1ns));
  EXPECT_TRUE(demand.update(false, *demand.next()));
  EXPECT_FALSE(demand.wanted());
  EXPECT_EQ(demand.next(), std::nullopt);
}

TEST(FrameDemand, AViewerWhoComesBackInTimeKeepsIt) {
  FrameDemand demand;
  demand.update(true, kStart);
  demand.update(false, kStart + 1s);
  EXPECT_FALSE(demand.update(true, kStart + 3s));
  EXPECT_EQ(demand.next(), std::nullopt);
  demand.update(false, kStart + 4s);
  EXPECT_EQ(demand.next(), kStart + 4s + FrameDemand::kKeptUnwatched) << "counted anew";
}

}  // namespace
}  // namespace roomcast::hub
