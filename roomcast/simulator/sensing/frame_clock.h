// SPDX-License-Identifier: Apache-2.0
// FrameClock: true capture times and timestamps of a sensor's frames, and which frames are lost.
//   true time of frame k   phase + k / (fps * (1 + rate_ppm * 1e-6))
//   stamp                  true time + clock offset + jitter of that frame
// Frames are lost singly or in bursts of 2 to 6, half of the lost frames each. Everything is a
// function of (unit, frame). Immutable.
#pragma once

#include <cstdint>

#include "roomcast/core/clock.h"

namespace roomcast::simulator {

/// Maximum values; each sensor draws its own between minus and plus. All zero: a perfect clock.
struct TimingOptions {
  double clock_offset_s = 2.0;  // between a sensor's clock and true time
  double rate_ppm = 20.0;       // of the frame rate
  double jitter_s = 0.001;      // standard deviation of a timestamp; at most twice that
  double lost_share = 0.005;    // of the frames
  bool same_instants = false;   // all sensors capture at the same instants

  [[nodiscard]] static TimingOptions perfect() { return {0, 0, 0, 0, true}; }
};

class FrameClock {
 public:
  FrameClock(const TimingOptions& options, double fps, std::uint32_t unit_key);

  [[nodiscard]] nanoseconds true_time(std::uint64_t frame) const;
  [[nodiscard]] nanoseconds stamp(std::uint64_t frame) const;
  /// Never true for the first frame.
  [[nodiscard]] bool is_lost(std::uint64_t frame) const;

  [[nodiscard]] double clock_offset_s() const { return offset_s_; }
  [[nodiscard]] double rate_ppm() const { return rate_ppm_; }

 private:
  [[nodiscard]] bool burst_covers(std::uint64_t first, std::uint64_t frame) const;

  double period_s_, phase_s_, offset_s_, rate_ppm_, jitter_s_, lost_share_;
  std::uint32_t key_;
};

}  // namespace roomcast::simulator
