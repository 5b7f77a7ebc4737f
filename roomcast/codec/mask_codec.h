// SPDX-License-Identifier: Apache-2.0
// The colour mask, given the depth: one bit for each pixel with a reading, almost free away from
// edges. docs/spec/codec.md §3.2. The decoder takes hostile bytes: every input gives some mask.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "roomcast/core/image.h"

namespace roomcast::codec {

/// Appends to `out`. Where `depth_mm` is 0 the mask is not looked at. Sizes must be equal.
void encode_mask(MaskView mask, DepthView depth_mm, std::vector<std::uint8_t>& out);

/// Fills `mask` with 0 and 255; 0 where `depth_mm` is 0. Sizes must be equal.
void decode_mask(std::span<const std::uint8_t> section, DepthView depth_mm,
                 ImageView<std::uint8_t> mask);

}  // namespace roomcast::codec
