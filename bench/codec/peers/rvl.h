// SPDX-License-Identifier: Apache-2.0
// RVL, a peer for comparison. Implemented from its description: Wilson, "Fast Lossless Depth Image
// Compression", ISS 2017: runs of zeros and of readings, differences folded to non-negative
// numbers, all in groups of three bits and a continuation bit.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace roomcast::bench {

/// Appends to `out`. The second overload codes depth differences for temporal RVL.
void encode_rvl(std::span<const std::uint16_t> depth, std::vector<std::uint8_t>& out);
void encode_rvl(std::span<const std::int16_t> differences, std::vector<std::uint8_t>& out);

/// Accepts only bytes from encode_rvl: they are trusted to fill the span.
void decode_rvl(std::span<const std::uint8_t> bytes, std::span<std::uint16_t> depth);
void decode_rvl(std::span<const std::uint8_t> bytes, std::span<std::int16_t> differences);

}  // namespace roomcast::bench
