// SPDX-License-Identifier: Apache-2.0
// Writes or reads a block's quantised coefficients. docs/spec/codec.md §2.4.3.
#pragma once

#include <cstdlib>

#include "roomcast/codec/live/live_contexts.h"

namespace roomcast::codec {

/// In zigzag order from `first` on. Reading leaves zero coefficients unchanged: clear `steps`
/// before.
template <class Coder>
void code_coefficients(Coder& coder, CoefficientModel& model, int first, BlockCoefficients& steps) {
  std::uint32_t count = 0;
  if constexpr (Coder::kWrites) {
    for (int i = kBlockPixels - 2; i >= first && count == 0; --i) {
      if (steps[kZigzag[static_cast<std::size_t>(i)]] != 0)
        count = static_cast<std::uint32_t>(i - first + 1);
    }
  }
  count = code_tree(coder, model.count, count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::size_t order = static_cast<std::size_t>(first) + i;
    if (order >= kBlockPixels) break;
    std::int32_t& step = steps[kZigzag[order]];
    const bool present = i + 1 == count || coder.bit(model.present[order], step != 0);
    if (!present) continue;
    const auto size = static_cast<std::uint32_t>(std::abs(step));
    const auto magnitude = static_cast<std::int32_t>(1 + code_number(coder,
                                                                     model.magnitude[i < 3    ? 0
                                                                                     : i < 10 ? 1
                                                                                              : 2],
                                                                     size - 1));
    step = coder.plain(step < 0, 1) ? -magnitude : magnitude;
  }
}

}  // namespace roomcast::codec
