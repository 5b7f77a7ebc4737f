// SPDX-License-Identifier: Apache-2.0
// FrameQuality: chooses one quality for depth and colour so that frames have a wanted size.
// Colour's quantiser is chosen, and the step of depth follows from it, so that both are about
// equally coarse. The sizes that a quantiser gives are learnt from the frames coded so far, for
// each role of a frame by itself. Single-threaded, no memory of its own.
#pragma once

#include <cstddef>

#include "roomcast/codec/payload/layer_schedule.h"

namespace roomcast::codec {

/// Wanted sizes of payloads. 0 bytes: no wish, the quality is that of the options.
struct FrameTarget {
  double bytes = 0;      // of a frame between key frames, on average
  double key_bytes = 0;  // of a key frame
};

class FrameQuality {
 public:
  /// Limits of VP9's quantiser, on libvpx's scale of 0 to 63. Finer ones cost bytes that nobody
  /// sees: registered colour is not as exact.
  static constexpr int kMinQuantizer = 4, kMaxQuantizer = 60;
  /// Limits of the step of depth, in standard deviations of the sensor's noise.
  static constexpr double kMinDepthStep = 1.25, kMaxDepthStep = 9;

  /// Valid from the next frame on.
  void set_target(const FrameTarget& target) { target_ = target; }
  [[nodiscard]] bool has_target() const { return target_.bytes > 0; }

  /// Chooses the quality of the next frame, whose colour has `color_pixels` (0: it has none).
  void choose(const FrameRole& role, std::size_t color_pixels);
  /// Of the chosen quality: colour's quantiser, and the step of depth in standard deviations.
  [[nodiscard]] int quantizer() const { return quantizer_; }
  [[nodiscard]] double depth_step() const;

  /// The sizes that the frame of the last choose() had.
  void coded(std::size_t depth_bytes, std::size_t color_bytes);

 private:
  /// Frames of one role.
  struct Sizes {
    double color_log2 = 0;   // of the bytes that colour would have at quantiser 0
    double depth_bytes = 0;  // at the present step; smoothed where there is colour
    bool known = false;
  };
  enum Kind { kKey, kReference, kDroppable, kKinds };

  [[nodiscard]] static Kind kind_of(const FrameRole& role);
  void guess_sizes(std::size_t color_pixels);
  [[nodiscard]] int quantizer_for_key() const;
  [[nodiscard]] int quantizer_between_keys() const;
  [[nodiscard]] int coarser_or_finer(double depth_bytes, double wanted_bytes) const;

  FrameTarget target_;
  Sizes sizes_[kKinds];
  Kind kind_ = kKey;      // of the last choice
  double droppable_ = 0;  // share of the frames between key frames that are droppable, smoothed
  std::size_t color_pixels_ = 0;
  int quantizer_ = 30;
};

}  // namespace roomcast::codec
