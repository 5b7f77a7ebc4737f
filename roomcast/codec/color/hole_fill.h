// SPDX-License-Identifier: Apache-2.0
// Fills what a mask leaves out with smooth colour from around, so that a video coder spends nothing
// on it. Method: push-pull (Gortler, Grzeszczuk, Szeliski, Cohen, The Lumigraph, 1996,
// section 3.4), with means of what is known.
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/core/image.h"

namespace roomcast::codec {

/// Keeps its memory from call to call.
class HoleFill {
 public:
  /// Overwrites `plane` where `known` is 0. Without any known pixel it is left as it is. Sizes must
  /// be equal.
  void fill(ImageView<std::uint8_t> plane, MaskView known);

 private:
  struct Level {
    Image<std::uint8_t> value, known;
  };
  std::vector<Level> levels_;
};

}  // namespace roomcast::codec
