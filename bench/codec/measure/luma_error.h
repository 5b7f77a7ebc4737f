// SPDX-License-Identifier: Apache-2.0
// Colour error against a reference: PSNR of luma over the valid pixels. BT.709 luma, full range,
// 0..255.
#pragma once

#include <cstdint>
#include <optional>

#include "roomcast/core/image.h"

namespace roomcast::bench {

/// Sums over the pixels of all added frames.
class LumaError {
 public:
  /// Adds the pixels of one frame where `seen` is not 0. The sizes must be equal.
  void add(ColorView decoded, ColorView reference, MaskView seen);
  void add(const LumaError& other);

  /// Empty when no pixel differs.
  [[nodiscard]] std::optional<double> psnr_db() const;

 private:
  double squares_ = 0;
  std::int64_t count_ = 0;
};

}  // namespace roomcast::bench
