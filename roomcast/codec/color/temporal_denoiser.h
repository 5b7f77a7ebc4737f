// SPDX-License-Identifier: Apache-2.0
// Takes a camera's noise out of still parts of a picture before it is encoded: noise would cost
// more bits than all that moves. Blocks of 8x8 pixels that differ from their running mean by no
// more than noise does are held: the mean is refined, and what is shown changes only, as a whole
// block, when the mean is known well and lies further from it than noise and a coarse quantiser
// put it. Any other block passes as it is. The noise is measured on
// the picture itself: the median difference, of which at least half the picture is thought to be
// still. Single-threaded.
#pragma once

#include <cstdint>

#include "roomcast/codec/color/i420_image.h"

namespace roomcast::codec {

class TemporalDenoiser {
 public:
  /// The picture to encode instead of `input`; valid until the next call. Always the same size.
  /// Still blocks improve in frames that later ones build on, the others would pay for it twice.
  I420Image& apply(const I420Image& input, bool reference);

  /// For each 8x8 pixels, 1 where the picture is not that of the newest reference; valid until the
  /// next call.
  [[nodiscard]] MaskView changed() const { return changed_; }

  /// Of luma, grey levels.
  [[nodiscard]] double noise_sigma() const { return sigma_; }

 private:
  struct Block {
    std::uint8_t held = 0;  // frames in a row without a change, up to what makes a mean known well
    std::uint16_t noise = 0;  // mean size of the differences while it was still
  };

  void begin(const I420Image& input);
  /// Learns its noise when it is.
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
