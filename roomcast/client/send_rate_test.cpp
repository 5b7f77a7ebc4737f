// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/send_rate.h"

#include <gtest/gtest.h>

namespace roomcast::client {
namespace {

using namespace std::chrono_literals;

constexpr HostTime kStart{1h};

TEST(SendRate, is_full_until_frames_pile_up) {
  SendRate rate;
  for (int i = 0; i < 100; ++i) rate.flowed(kStart + i * 33ms);
  EXPECT_EQ(rate.share(), 1);
}

TEST(SendRate, is_cut_once_for_frames_that_pile_up_together) {
  SendRate rate;
  for (int i = 0; i < 10; ++i) rate.piled_up(kStart + i * 33ms);
  EXPECT_DOUBLE_EQ(rate.share(), SendRate::kCut);
  rate.piled_up(kStart + SendRate::kCutInterval);
  EXPECT_DOUBLE_EQ(rate.share(), SendRate::kCut * SendRate::kCut);
}

TEST(SendRate, never_falls_below_its_least) {
  SendRate rate;
  for (int i = 0; i < 100; ++i) rate.piled_up(kStart + i * 1s);
  EXPECT_EQ(rate.share(), SendRate::kMinShare);
}

TEST(SendRate, is_raised_step_by_step_while_frames_flow) {
  SendRate rate;
  rate.piled_up(kStart);
  rate.flowed(kStart + 900ms);
  EXPECT_DOUBLE_EQ(rate.share(), SendRate::kCut) << "not yet";
  rate.flowed(kStart + 1s);
  EXPECT_DOUBLE_EQ(rate.share(), SendRate::kCut + SendRate::kRaise);
  for (int second = 2; second < 20; ++second) rate.flowed(kStart + second * 1s);
  EXPECT_EQ(rate.share(), 1);
}

TEST(SendRate, is_not_raised_while_frames_still_pile_up) {
  SendRate rate;
  rate.piled_up(kStart);
  rate.piled_up(kStart + 400ms);
  rate.flowed(kStart + 1100ms);
  EXPECT_DOUBLE_EQ(rate.share(), SendRate::kCut);
}

}  // namespace
}  // namespace roomcast::client
