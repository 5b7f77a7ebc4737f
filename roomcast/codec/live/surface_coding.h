// SPDX-License-Identifier: Apache-2.0
// Writes or reads a block's surfaces: which candidate predicts each one, and the quantised
// coefficients. docs/spec/codec.md §2.4.3, §2.4.4 steps 1 to 4.
#pragma once

#include <cstdlib>

#include "roomcast/codec/live/block_code.h"
#include "roomcast/codec/live/live_contexts.h"
#include "roomcast/codec/live/surface_prediction.h"

namespace roomcast::codec {

template <class Coder, int Steps>
std::int32_t code_signed(Coder& coder, NumberModel<Steps>& model, std::int32_t value) {
  return unfold_sign(code_number(coder, model, fold_sign(value)));
}

/// In zigzag order from `first` on. Reading leaves zero coefficients unchanged: clear `steps`
/// before.
template <class Coder>
void code_coefficients(Coder& coder, CoefficientModel& model, std::size_t first,
                       BlockCoefficients& steps) {
  std::uint32_t count = 0;
  if constexpr (Coder::kWrites) {
    for (std::size_t end = kBlockPixels - 1; end > first && count == 0; --end) {
      if (steps[kZigzag[end - 1]] != 0) count = static_cast<std::uint32_t>(end - first);
    }
  }
  count = code_tree(coder, model.count, count);
  for (std::uint32_t i = 0; i < count && first + i < kBlockPixels; ++i) {
    std::int32_t& step = steps[kZigzag[first + i]];
    const bool present = i + 1 == count || coder.bit(model.present[first + i], step != 0);
    if (!present) continue;
    auto& magnitudes = model.magnitude[i < 3 ? 0 : i < 10 ? 1 : 2];
    const auto size = static_cast<std::uint32_t>(std::abs(step));
    const auto coded = static_cast<std::int32_t>(1 + code_number(coder, magnitudes, size - 1));
    step = coder.plain(step < 0, 1) ? -coded : coded;
  }
}

/// 0 to 2: one bit for more than 0, one for 2.
template <class Coder>
std::uint8_t code_up_to_two(Coder& coder, AdaptiveBit& any, AdaptiveBit& two, std::uint8_t value) {
  if (!coder.bit(any, value > 0)) return 0;
  return coder.bit(two, value > 1) ? std::uint8_t{2} : std::uint8_t{1};
}

/// One bit for each known candidate but the last.
template <class Coder>
void code_candidate(Coder& coder, LiveContexts& contexts, const SurfaceCandidates& candidates,
                    std::size_t which, SurfaceCode& surface) {
  auto& models = contexts.candidate[which * 2 + candidates[2].known];
  std::uint8_t last_known = 0;
  for (std::uint8_t i = 0; i < kSurfaceCandidates; ++i) {
    if (candidates[i].known) last_known = i;
  }
  for (std::uint8_t i = 0; i < last_known; ++i) {
    if (candidates[i].known && coder.bit(models[i], surface.candidate == i)) {
      surface.candidate = i;
      return;
    }
  }
  surface.candidate = last_known;
}

/// Codes surface `which` (0, 1) of a block.
template <class Coder>
void code_surface(Coder& coder, LiveContexts& contexts, const SurfaceCandidates& candidates,
                  std::size_t which, SurfaceCode& surface) {
  code_candidate(coder, contexts, candidates, which, surface);
  BlockCoefficients& steps = surface.steps;
  if constexpr (!Coder::kWrites) steps.fill(0);
  surface.finer = code_up_to_two(coder, contexts.finer[0], contexts.finer[1], surface.finer);
  steps[0] = code_signed(coder, contexts.mean[which], steps[0]);
  steps[1] = code_signed(coder, contexts.slope[which][0], steps[1]);
  steps[8] = code_signed(coder, contexts.slope[which][1], steps[8]);
  code_coefficients(coder, contexts.coefficients[surface.finer > 0], 3, steps);
}

}  // namespace roomcast::codec
