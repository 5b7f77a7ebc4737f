// SPDX-License-Identifier: Apache-2.0
// Codes the colour mask of one frame by itself, given its depth: one bit for each pixel with a
// reading, almost free away from edges. docs/spec/codec.md §3.2. The decoder accepts any bytes:
// every input gives some mask.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "roomcast/core/image.h"

namespace roomcast::codec {

/// Appends to `out`. `known` becomes 1 where `mask` is not 0, else 0; where `depth_mm` is 0, `mask`
/// is ignored and `known` copies the row above. Sizes must be equal.
void encode_intra_mask(MaskView mask, DepthView depth_mm, ImageView<std::uint8_t> known,
                       std::vector<std::uint8_t>& out);

/// Fills `known` with the values that the encoder had. Sizes must be equal.
void decode_intra_mask(std::span<const std::uint8_t> section, DepthView depth_mm,
                       ImageView<std::uint8_t> known);

}  // namespace roomcast::codec
