// SPDX-License-Identifier: Apache-2.0
// FrameTiming: the headset's frame rate, the viewer's time per frame, and the number of frames
// missed. Pure.
#pragma once

#include <chrono>
#include <cstdint>

#include <openxr/openxr.h>

#include "roomcast/core/clock.h"

namespace roomcast::viewer::xr {

class FrameTiming {
 public:
  /// Adds a frame with display time `display`; the headset shows one every `period`. `ours`: time
  /// from the end of the headset's wait until the frame was submitted.
  void add(XrTime display, XrDuration period, nanoseconds ours) {
    if (frames_ > 0 && period > 0) missed_ += missed_between(last_display_, display, period);
    last_display_ = display;
    period_ = nanoseconds(period);
    ours_ = frames_ == 0 ? ours : ours_ + (ours - ours_) / kSmoothing;
    ++frames_;
  }

  [[nodiscard]] std::uint64_t frames() const { return frames_; }
  [[nodiscard]] std::uint64_t missed() const { return missed_; }
  /// Smoothed.
  [[nodiscard]] nanoseconds ours() const { return ours_; }
  [[nodiscard]] double headset_per_s() const {
    return period_.count() > 0 ? 1e9 / static_cast<double>(period_.count()) : 0;
  }

 private:
  static constexpr int kSmoothing = 16;

  static std::uint64_t missed_between(XrTime before, XrTime now, XrDuration period) {
    const XrDuration periods = (now - before + period / 2) / period;
    return periods > 1 ? static_cast<std::uint64_t>(periods - 1) : 0;
  }

  std::uint64_t frames_ = 0, missed_ = 0;
  XrTime last_display_ = 0;
  nanoseconds period_{}, ours_{};
};

}  // namespace roomcast::viewer::xr
