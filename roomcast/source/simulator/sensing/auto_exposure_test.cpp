// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/simulator/sensing/auto_exposure.h"

#include <chrono>
#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::sim {
namespace {

using std::chrono::milliseconds;

TEST(AutoExposure, leaves_the_empty_room_alone) {
  AutoExposure control(0.3F);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(control.next(milliseconds(33 * i), 0.3F), 1.0F);
}

TEST(AutoExposure, brightens_a_darker_picture_with_a_lag) {
  AutoExposure control(0.3F);
  EXPECT_EQ(control.next(milliseconds(0), 0.2F), 1.0F);  // knows of it only now
  float gain = 1.0F;
  for (int i = 1; i <= 12; ++i) {
    const float next = control.next(milliseconds(33 * i), 0.2F);
    EXPECT_GT(next, gain);
    gain = next;
  }
  EXPECT_NEAR(std::log(gain) / std::log(1.5F), 1.0F - std::exp(-1.0F), 0.01F);  // after 0.4 s
  for (int i = 13; i < 200; ++i) gain = control.next(milliseconds(33 * i), 0.2F);
  EXPECT_NEAR(gain, 1.5F, 1e-3F);
}

TEST(AutoExposure, goes_no_further_than_one_stop) {
  AutoExposure control(0.3F);
  float gain = 1.0F;
  for (int i = 0; i < 400; ++i) gain = control.next(milliseconds(33 * i), 0.0F);
  EXPECT_NEAR(gain, 2.01F, 0.01F);
}

}  // namespace
}  // namespace roomcast::sim
