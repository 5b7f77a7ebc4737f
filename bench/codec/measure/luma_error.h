// SPDX-License-Identifier: Apache-2.0
// How far decoded colour is from a reference, as PSNR of luma over the pixels that are to be
// believed. Luma after BT.709 with full range, 0..255.
#pragma once

#include <cstdint>
#include <optional>

#include "roomcast/core/image.h"

namespace roomcast::bench {

/// Sums over pixels; those of frames can be added up.
class LumaError {
 public:
  /// Takes in the pixels of one frame where `seen` is not 0. Sizes must be equal.
  void add(ColorView decoded, ColorView reference, MaskView seen);
  void add(const LumaError& other);

  /// Nothing when no pixel differs.
  [[nodiscard]] std::optional<double> psnr_db() const;

 private:
  double squares_ = 0;
  std::int64_t count_ = 0;
};

}  // namespace roomcast::bench
