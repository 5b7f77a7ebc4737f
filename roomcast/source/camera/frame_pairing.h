// SPDX-License-Identifier: Apache-2.0
// FramePairing: a camera's depth and colour pictures come one by one; those of about the same
// instant become a frame. Pictures are swapped in, not copied: the caller gets memory back to fill
// again. Single-threaded.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "roomcast/core/clock.h"
#include "roomcast/source/frame_source.h"

namespace roomcast::source {

class FramePairing {
 public:
  /// Called with each frame; it may swap pixels out of it. `index` and `device_time` are set, the
  /// depth picture's time counts.
  using Deliver = std::function<void(CapturedFrame&)>;

  /// `has_color` false: every depth picture is a frame.
  FramePairing(double fps, bool has_color, Deliver deliver);

  /// Times of one clock, growing; both are exchanged for older memory.
  void depth(nanoseconds device_time, DepthImage& picture_mm);
  void color(nanoseconds device_time, ColorImage& picture);

  /// Depth pictures that found no colour within half a frame period, before a newer one came.
  [[nodiscard]] std::uint64_t unpaired_count() const { return unpaired_count_; }
  [[nodiscard]] std::uint64_t frame_count() const { return frame_count_; }

  /// After a camera has come back: pictures from before are not paired with those of now.
  void forget();

 private:
  [[nodiscard]] bool together() const;
  void deliver();

  const bool has_color_;
  const nanoseconds tolerance_;
  const Deliver deliver_;
  CapturedFrame waiting_;
  std::optional<nanoseconds> depth_time_, color_time_;  // of what waits
  std::uint64_t unpaired_count_ = 0;
  std::uint64_t frame_count_ = 0;
};

}  // namespace roomcast::source
