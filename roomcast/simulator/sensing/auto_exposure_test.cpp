// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/auto_exposure.h"

#include <chrono>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace roomcast::simulator {
namespace {

using std::chrono::milliseconds;

/// The gains of frames 33 ms apart under constant light.
std::vector<float> gains(float brightness, int frames) {
  AutoExposure control(0.3F);
  std::vector<float> gains;
  for (int i = 0; i < frames; ++i) {
    const auto time = milliseconds(33 * i);
    gains.push_back(control.next(time));
    if (control.is_due(time)) control.meter(time, brightness);
  }
  return gains;
}

TEST(AutoExposure, leaves_the_empty_room_alone) {
  for (const float gain : gains(0.3F, 20)) EXPECT_EQ(gain, 1.0F);
}

TEST(AutoExposure, brightens_a_darker_picture_with_a_lag) {
  const std::vector<float> seen = gains(0.2F, 200);
  EXPECT_EQ(seen[0], 1.0F);  // metering takes effect on the next frame
  for (std::size_t i = 1; i < 60; ++i) EXPECT_GT(seen[i], seen[i - 1]);
  const float after_lag = std::log(seen[12]) / std::log(1.5F);  // 0.4 s
  EXPECT_NEAR(after_lag, 1.0F - std::exp(-1.0F), 0.01F);
  EXPECT_NEAR(seen.back(), 1.5F, 1e-3F);
}

TEST(AutoExposure, goes_no_further_than_one_stop) {
  EXPECT_NEAR(gains(0.0F, 400).back(), 2.01F, 0.01F);
}

TEST(AutoExposure, meters_five_times_a_second) {
  AutoExposure control(0.3F);
  int metered = 0;
  for (int ms = 0; ms < 10'000; ms += 10) {
    if (!control.is_due(milliseconds(ms))) continue;
    control.meter(milliseconds(ms), 0.3F);
    ++metered;
  }
  EXPECT_EQ(metered, 50);
}

}  // namespace
}  // namespace roomcast::simulator
