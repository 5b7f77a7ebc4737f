// SPDX-License-Identifier: Apache-2.0
// The colour mask of a frame as changes to the one before: a mask that stays costs a few bytes.
// docs/spec/codec.md §3.2. The decoder takes hostile bytes: every input gives some mask.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "roomcast/core/image.h"

namespace roomcast::codec {

/// Appends to `out`. `known` holds the mask before, 0 and 1, and becomes that of this frame: 1
/// where `mask` is not 0; where `depth_mm` is 0 it stays as it is. Sizes must be equal.
void encode_mask_change(MaskView mask, DepthView depth_mm, ImageView<std::uint8_t> known,
                        std::vector<std::uint8_t>& out);

/// Changes `known` likewise. Sizes must be equal.
void decode_mask_change(std::span<const std::uint8_t> section, DepthView depth_mm,
                        ImageView<std::uint8_t> known);

}  // namespace roomcast::codec
