// SPDX-License-Identifier: Apache-2.0
// Decodes an LZFSE block whose literals and matches are coded by finite-state entropy: a header
// with the frequencies of all symbols, the literals, then triples of literal count, match length
// and distance. Both parts are read from their ends backwards. Thread-safe (no state).
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "roomcast/recording/lzfse/lz_output.h"

namespace roomcast::recording {

/// `bytes` begin with the block's magic number, "bvx1" or "bvx2", and may go on after the block.
/// The block's size; nothing if it is damaged.
[[nodiscard]] std::optional<std::size_t> decode_entropy_block(std::span<const std::uint8_t> bytes,
                                                              LzOutput& out);

}  // namespace roomcast::recording
