// SPDX-License-Identifier: Apache-2.0
// Decodes LZFSE, the compression of depth in Record3D's files: blocks of plain bytes, of LZVN, or
// of matches and literals that are coded by finite-state entropy (Duda 2013). The format is that of
// Apple's published reference (github.com/lzfse/lzfse); there is no encoder here. Bytes are
// untrusted. Thread-safe (no state).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace roomcast::recording {

/// Replaces `out` by the decoded bytes. False if `bytes` are damaged, incomplete, or do not decode
/// to exactly `size` bytes.
[[nodiscard]] bool decode_lzfse(std::span<const std::uint8_t> bytes, std::size_t size,
                                std::vector<std::uint8_t>& out);

}  // namespace roomcast::recording
