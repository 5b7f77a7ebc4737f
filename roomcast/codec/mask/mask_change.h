// SPDX-License-Identifier: Apache-2.0
// Codes the colour mask of a frame as changes from the reference: a mask that stays costs a few
// bytes. docs/spec/codec.md §3.3. The decoder accepts any bytes: every input gives some mask.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "roomcast/core/image.h"

namespace roomcast::codec {

/// Appends to `out`. `known` contains the reference mask, 0 and 1, and becomes that of this frame:
/// 1 where `mask` is not 0; unchanged where `depth_mm` is 0. Sizes must be equal.
void encode_mask_change(MaskView mask, DepthView depth_mm, ImageView<std::uint8_t> known,
                        std::vector<std::uint8_t>& out);

/// Changes `known` as the encoder does. Sizes must be equal.
void decode_mask_change(std::span<const std::uint8_t> section, DepthView depth_mm,
                        ImageView<std::uint8_t> known);

}  // namespace roomcast::codec
