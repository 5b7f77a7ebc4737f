// SPDX-License-Identifier: Apache-2.0
// Converts PNG bytes to rows of pixels and back, through libpng. libpng reports errors by longjmp,
// which does not leave this unit. Thread-safe (no state).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "roomcast/core/image.h"

namespace roomcast::io {

/// Decodes a 16-bit grey PNG of exactly the size of `depth`. Returns the problem, or an empty
/// string.
[[nodiscard]] std::string decode_depth_png(std::span<const std::uint8_t> bytes,
                                           ImageView<std::uint16_t> depth);
/// Decodes any PNG of exactly the size of `color`, without alpha. Returns the problem, or an empty
/// string.
[[nodiscard]] std::string decode_color_png(std::span<const std::uint8_t> bytes,
                                           ImageView<Rgb8> color);
/// Decodes an 8-bit grey PNG of exactly the size of `mask`. Returns the problem, or an empty
/// string.
[[nodiscard]] std::string decode_mask_png(std::span<const std::uint8_t> bytes,
                                          ImageView<std::uint8_t> mask);

/// Appends a PNG file. Returns the problem, or an empty string.
[[nodiscard]] std::string encode_depth_png(DepthView depth, std::vector<std::uint8_t>& bytes);
[[nodiscard]] std::string encode_color_png(ColorView color, std::vector<std::uint8_t>& bytes);
[[nodiscard]] std::string encode_mask_png(MaskView mask, std::vector<std::uint8_t>& bytes);

}  // namespace roomcast::io
