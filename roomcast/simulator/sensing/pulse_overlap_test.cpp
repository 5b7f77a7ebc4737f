// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/pulse_overlap.h"

#include <gtest/gtest.h>

namespace roomcast::simulator {
namespace {

constexpr double kPeriod_s = 1.0 / 30;

TEST(PulseOverlapTest, equal_instants_overlap_wholly) {
  EXPECT_NEAR(pulse_overlap(0, kPeriod_s), 1, 1e-9);
  EXPECT_NEAR(pulse_overlap(7 * kPeriod_s, kPeriod_s), 1, 1e-9);
}

TEST(PulseOverlapTest, pulses_that_take_turns_do_not_overlap) {
  // The delay that the maker of the Azure Kinect asks for between two synchronised cameras.
  for (int turn = 1; turn < 9; ++turn) EXPECT_EQ(pulse_overlap(160e-6 * turn, kPeriod_s), 0);
  EXPECT_EQ(pulse_overlap(0.5 * kPeriod_s, kPeriod_s), 0);
}

TEST(PulseOverlapTest, a_shift_by_one_pulse_leaves_eight_of_nine) {
  EXPECT_NEAR(pulse_overlap(kPulseSpacing_s, kPeriod_s), 8.0 / 9, 1e-9);
  EXPECT_NEAR(pulse_overlap(-kPulseSpacing_s, kPeriod_s), 8.0 / 9, 1e-9);
}

/// Seconds until pulses that met meet again: the spacing divided by the difference of the clocks.
TEST(PulseOverlapTest, pulses_beat_at_the_difference_of_the_frame_clocks) {
  constexpr double kDifference = 40e-6;  // 40 ppm
  int meetings = 0;
  bool met = true;
  for (int frame = 0; frame < 30 * 120; ++frame) {
    const bool meets = pulse_overlap(frame * kPeriod_s * kDifference, kPeriod_s) > 0;
    meetings += meets && !met;
    met = meets;
  }
  EXPECT_EQ(meetings, 3);  // 1.575 ms / 40 ppm = 39 s, in 120 s
}

}  // namespace
}  // namespace roomcast::simulator
