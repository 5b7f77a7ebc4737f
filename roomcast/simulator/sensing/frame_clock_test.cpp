// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/frame_clock.h"

#include <chrono>
#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::simulator {
namespace {

double seconds(nanoseconds time) {
  return std::chrono::duration<double>(time).count();
}

TEST(FrameClock, a_perfect_one_takes_frame_k_at_k_over_fps_and_loses_none) {
  const FrameClock clock(TimingOptions::perfect(), 30.0, 77);
  for (std::uint64_t frame = 0; frame < 1000; ++frame) {
    EXPECT_NEAR(seconds(clock.true_time(frame)), static_cast<double>(frame) / 30.0, 1e-9);
    EXPECT_EQ(clock.stamp(frame), clock.true_time(frame));
    EXPECT_FALSE(clock.is_lost(frame));
  }
}

TEST(FrameClock, stamps_are_off_by_the_offset_and_jitter_and_keep_their_order) {
  TimingOptions options;
  const FrameClock clock(options, 30.0, 77);
  EXPECT_LE(std::abs(clock.clock_offset_s()), options.clock_offset_s);
  double squares = 0;
  for (std::uint64_t frame = 1; frame < 3000; ++frame) {
    const double jitter =
        seconds(clock.stamp(frame) - clock.true_time(frame)) - clock.clock_offset_s();
    EXPECT_LE(std::abs(jitter), 2.0 * options.jitter_s + 1e-9);
    EXPECT_GT(clock.stamp(frame), clock.stamp(frame - 1));
    squares += jitter * jitter;
  }
  EXPECT_NEAR(std::sqrt(squares / 3000), options.jitter_s, 0.15 * options.jitter_s);
}

TEST(FrameClock, frames_come_faster_by_the_rate_it_states) {
  const FrameClock clock({}, 30.0, 5);
  const double elapsed = seconds(clock.true_time(30'000'000) - clock.true_time(0));
  EXPECT_NEAR(1e6 / elapsed, 1.0 + 1e-6 * clock.rate_ppm(), 1e-9);
  EXPECT_LE(std::abs(clock.rate_ppm()), 20.0);
}

TEST(FrameClock, loses_the_requested_share_singly_and_in_bursts) {
  TimingOptions options;
  options.lost_share = 0.04;
  const FrameClock clock(options, 30.0, 6);
  constexpr std::uint64_t kDrawnFrames = 100'000;
  double lost = 0, alone = 0;
  for (std::uint64_t frame = 1; frame < kDrawnFrames; ++frame) {
    if (!clock.is_lost(frame)) continue;
    ++lost;
    alone += !clock.is_lost(frame - 1) && !clock.is_lost(frame + 1);
  }
  EXPECT_NEAR(lost / kDrawnFrames, 0.04, 0.004);
  EXPECT_NEAR(alone / lost, 0.5, 0.1);
  EXPECT_FALSE(clock.is_lost(0));
}

TEST(FrameClock, units_differ_in_phase_offset_and_rate) {
  const FrameClock one({}, 30.0, 1), two({}, 30.0, 2);
  EXPECT_NE(one.true_time(0), two.true_time(0));
  EXPECT_NE(one.clock_offset_s(), two.clock_offset_s());
  EXPECT_NE(one.rate_ppm(), two.rate_ppm());
  EXPECT_LT(seconds(one.true_time(0)), 1.0 / 30.0);
}

}  // namespace
}  // namespace roomcast::simulator
