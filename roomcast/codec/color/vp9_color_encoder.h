// SPDX-License-Identifier: Apache-2.0
// Encodes registered colour as VP9 in real time, through libvpx. docs/spec/codec.md §3.1. Pixels
// that the colour camera does not see keep their last colour, or are filled from their surroundings
// if they never had any: still pixels cost nothing, black ones would cost two thirds of the stream.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "roomcast/codec/color/color_activity.h"
#include "roomcast/codec/color/hole_fill.h"
#include "roomcast/codec/color/i420_image.h"
#include "roomcast/codec/color/temporal_denoiser.h"
#include "roomcast/codec/payload/block_need.h"
#include "roomcast/codec/payload/encoder_options.h"
#include "roomcast/codec/payload/layer_schedule.h"

namespace roomcast::codec {

class Vp9ColorEncoder {
 public:
  /// `options` must be legal. kUnavailable if libvpx does not start.
  static Result<std::unique_ptr<Vp9ColorEncoder>> create(const FrameEncoderOptions& options);
  ~Vp9ColorEncoder();

  /// Appends one VP9 frame to `out`. Sizes must be those of the options; `seen` is in the depth
  /// grid. The first frame's role is a key frame's; frames of layer 1 and up change no decoder
  /// state. `needs`, in the depth grid, says which blocks are needed; empty: all.
  [[nodiscard]] Status encode(ColorView color, MaskView seen, FrameRole role,
                              std::vector<std::uint8_t>& out, BlockNeedsView needs = {});

  /// Fixes the quantiser of the next frames, 0 to 63; the rate then has no effect. Nothing: libvpx
  /// chooses it by the rate.
  void fix_quantizer(std::optional<int> quantizer) { fixed_quantizer_ = quantizer; }

  /// Sets the rate from the next frame on, as FrameEncoderOptions.color_kbit_per_s. kUnavailable if
  /// libvpx refuses.
  [[nodiscard]] Status set_rate(int kbit_per_s);

 private:
  struct Codec;
  Vp9ColorEncoder(const FrameEncoderOptions& options, std::unique_ptr<Codec> codec);
  void remember_seen();
  void fill_never_seen();
  void choose_quality();
  void refine_still_blocks(FrameRole role);
  [[nodiscard]] bool limit_quantizer(FrameRole role);
  void set_layer(bool droppable);
  void take_packets(std::vector<std::uint8_t>& out);
  void set_active(MaskView active);
  [[nodiscard]] MaskView left_out(BlockNeedsView needs, FrameRole role);

  FrameEncoderOptions options_;
  std::unique_ptr<Codec> codec_;
  I420Image input_;
  TemporalDenoiser hold_;
  ColorActivity activity_;
  MaskImage left_out_;  // of each 16x16 pixels, 1 where the frame leaves them out
  MaskImage seen_;      // mask of the newest frame, in colour's size
  MaskImage ever_seen_, chroma_ever_seen_;
  HoleFill hole_fill_;
  std::int64_t frame_count_ = 0;
  std::int64_t key_at_ = 0;          // frame_count_ of the newest key frame
  std::size_t bytes_since_key_ = 0;  // without the key frame's own
  unsigned key_quantizer_;           // for the next key frame
  std::optional<int> fixed_quantizer_;
  int still_quantizer_ = 0;  // that still blocks were coded with, if it is fixed
};

}  // namespace roomcast::codec
