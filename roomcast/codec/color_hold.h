// SPDX-License-Identifier: Apache-2.0
// Takes a camera's noise out of still parts of a picture before it is encoded: noise would cost
// more bits than all that moves. Blocks of 8x8 pixels that differ from their running mean by no
// more than noise does are held: the mean is refined, and what is shown changes only when the mean
// has moved by more than a grey level. Any other block passes as it is. The noise is measured on
// the picture itself: the median difference, of which at least half the picture is thought to be
// still. Single-threaded.
#pragma once

#include <cstdint>

#include "roomcast/codec/i420_image.h"

namespace roomcast::codec {

class ColorHold {
 public:
  /// The picture to encode instead of `input`; valid until the next call. Always the same size.
  I420Image& apply(const I420Image& input);

  /// Of luma, grey levels.
  [[nodiscard]] double noise_sigma() const { return sigma_; }

 private:
  void begin(const I420Image& input);
  void measure_noise(const Image<std::uint8_t>& luma);
  void pass_block(const I420Image& input, int block_x, int block_y);
  void hold_block(const I420Image& input, int block_x, int block_y);

  /// Running means, 1/16 grey levels.
  struct Means {
    Image<std::int16_t> y, cb, cr;
  };
  Means mean_;
  I420Image shown_;
  double sigma_ = 2;
};

}  // namespace roomcast::codec
