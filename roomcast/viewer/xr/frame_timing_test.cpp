// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/xr/frame_timing.h"

#include <gtest/gtest.h>

namespace roomcast::viewer::xr {
namespace {

using namespace std::chrono_literals;

constexpr XrDuration kPeriod = 11'111'111;

TEST(FrameTiming, counts_frames_that_came_too_late) {
  FrameTiming timing;
  XrTime display = 1'000'000'000;
  for (int i = 0; i < 10; ++i) timing.add(display += kPeriod, kPeriod, 4ms);
  EXPECT_EQ(timing.missed(), 0U);
  timing.add(display += 3 * kPeriod + 100, kPeriod, 4ms);
  EXPECT_EQ(timing.missed(), 2U);
  EXPECT_EQ(timing.frames(), 11U);
  EXPECT_NEAR(timing.headset_per_s(), 90, 0.01);
  EXPECT_EQ(timing.ours(), 4ms);
}

TEST(FrameTiming, one_slow_frame_is_not_the_rule) {
  FrameTiming timing;
  XrTime display = 0;
  for (int i = 0; i < 100; ++i) timing.add(display += kPeriod, kPeriod, 4ms);
  timing.add(display += kPeriod, kPeriod, 100ms);
  EXPECT_LT(timing.ours(), 12ms);
}

}  // namespace
}  // namespace roomcast::viewer::xr
