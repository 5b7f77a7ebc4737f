// SPDX-License-Identifier: Apache-2.0
// Registered colour to VP9 for real time, through libvpx. docs/spec/codec.md §3.1.
// Pixels that the colour camera does not see keep the colour they last had (from key frame to key
// frame, then they are filled from around): still pixels cost nothing, black ones would cost two
// thirds of the stream.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "roomcast/codec/frame_codec.h"
#include "roomcast/codec/hole_fill.h"
#include "roomcast/codec/i420_image.h"
#include "roomcast/codec/layer_schedule.h"

namespace roomcast::codec {

class Vp9ColorEncoder {
 public:
  /// `options` must be legal. kUnavailable if libvpx does not start.
  static Result<std::unique_ptr<Vp9ColorEncoder>> create(const FrameEncoderOptions& options);
  ~Vp9ColorEncoder();

  /// Appends one VP9 frame to `out`. Sizes must be those of the options. The first frame's role is
  /// a key frame's; frames of layer 1 and up leave no trace.
  [[nodiscard]] Status encode(ColorView color, MaskView seen, FrameRole role,
                              std::vector<std::uint8_t>& out);

  /// What the newest frame was encoded from, for measuring.
  [[nodiscard]] const I420Image& input() const { return input_; }

 private:
  struct Codec;
  Vp9ColorEncoder(const FrameEncoderOptions& options, std::unique_ptr<Codec> codec);
  void fill_unseen(MaskView seen);

  const FrameEncoderOptions options_;
  std::unique_ptr<Codec> codec_;
  I420Image input_;
  MaskImage chroma_seen_;
  HoleFill hole_fill_;
  std::int64_t frame_count_ = 0;
};

}  // namespace roomcast::codec
