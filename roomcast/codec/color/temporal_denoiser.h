// SPDX-License-Identifier: Apache-2.0
// Removes a camera's noise from still parts of a picture before it is encoded: noise would cost
// more bits than all motion. A block of 8x8 pixels that differs from its running mean by no more
// than noise is held: its mean is refined, and the shown block is replaced as a whole only when the
// mean is accurate and differs from it by more than noise and a coarse quantiser explain. Any other
// block passes unchanged. The noise is measured on the picture itself, from the median difference,
// which assumes that at least half the picture is still. Single-threaded.
#pragma once

#include <cstdint>

#include "roomcast/codec/color/i420_image.h"

namespace roomcast::codec {

class TemporalDenoiser {
 public:
  /// Returns the picture to encode instead of `input`; valid until the next call. Always the same
  /// size. Still blocks improve only in `reference` frames, or the next reference would code the
  /// change again. `left_out` is not 0 for the 16x16 pixels that the frame does not code: they stay
  /// as they are shown, and have changed once they are coded again. libvpx codes some of them
  /// anyway, in turn, to refresh still parts. Empty: none.
  I420Image& apply(const I420Image& input, bool reference, MaskView left_out = {});

  /// One entry for each 8x8 pixels, 1 where the picture differs from the newest reference; valid
  /// until the next call.
  [[nodiscard]] MaskView changed() const { return changed_; }

  /// Standard deviation of luma, grey levels.
  [[nodiscard]] double noise_sigma() const { return sigma_; }

 private:
  struct Block {
    std::uint8_t held = 0;    // consecutive frames without a change, up to kConvergedFrames
    std::uint16_t noise = 0;  // mean absolute difference while the block was still
  };

  void begin(const I420Image& input);
  /// Also updates the noise of a still block.
  bool is_still(const Image<std::uint8_t>& luma, int block_x, int block_y);
  static void learn_noise(Block& block, int mean_size);
  void measure_noise(const Image<std::uint8_t>& luma);
  void pass_block(const I420Image& input, int block_x, int block_y);
  void hold_block(const I420Image& input, int block_x, int block_y, bool reference);

  /// Running means, 1/64 grey levels.
  struct Means {
    Image<std::int16_t> y, cb, cr;
  };
  Means mean_;
  I420Image shown_;
  MaskImage changed_;
  bool was_reference_ = true;
  Image<Block> blocks_;
  double sigma_ = 2;
};

}  // namespace roomcast::codec
