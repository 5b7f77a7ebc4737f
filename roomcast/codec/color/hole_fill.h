// SPDX-License-Identifier: Apache-2.0
// Fills the pixels outside a mask with smooth colour from their surroundings, so that a video coder
// spends no bits on them. Method: push-pull (Gortler, Grzeszczuk, Szeliski, Cohen, The Lumigraph,
// 1996, section 3.4), with means of the known pixels.
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/core/image.h"

namespace roomcast::codec {

/// Keeps its memory from call to call.
class HoleFill {
 public:
  /// Overwrites `plane` where `known` is 0. Without any known pixel `plane` stays unchanged. Sizes
  /// must be equal.
  void fill(ImageView<std::uint8_t> plane, MaskView known);

 private:
  struct Level {
    Image<std::uint8_t> value, known;
  };
  std::vector<Level> levels_;
};

}  // namespace roomcast::codec
