// SPDX-License-Identifier: Apache-2.0
// FramePairing: pairs a camera's depth and colour pictures of about the same instant to frames.
// Pictures are swapped in, not copied: the caller gets memory back to reuse. Single-threaded.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "roomcast/core/clock.h"
#include "roomcast/source/frame_source.h"

namespace roomcast::source {

class FramePairing {
 public:
  /// Called with each frame; it may swap out the pixels. `index` and `device_time` are set; the
  /// time is the depth picture's.
  using Deliver = std::function<void(CapturedFrame&)>;

  /// `has_color` false: every depth picture is a frame.
  FramePairing(double fps, bool has_color, Deliver deliver);

  /// Times are of one clock and increase; each picture is exchanged for older memory.
  void depth(nanoseconds device_time, DepthImage& picture_mm);
  void color(nanoseconds device_time, ColorImage& picture);

  /// Number of depth pictures without a colour picture within half a frame period before a newer
  /// depth picture came.
  [[nodiscard]] std::uint64_t unpaired_count() const { return unpaired_count_; }
  [[nodiscard]] std::uint64_t frame_count() const { return frame_count_; }

  /// Call after reopening a camera: earlier pictures are not paired with new ones.
  void forget();

 private:
  [[nodiscard]] bool together() const;
  void deliver();

  const bool has_color_;
  const nanoseconds tolerance_;
  const Deliver deliver_;
  CapturedFrame waiting_;
  std::optional<nanoseconds> depth_time_, color_time_;  // of the waiting pictures
  std::uint64_t unpaired_count_ = 0;
  std::uint64_t frame_count_ = 0;
};

}  // namespace roomcast::source
