// SPDX-License-Identifier: Apache-2.0
// Decodes the payload of an LZVN block of LZFSE: opcodes of one to three bytes, each with literals
// to copy, a match of earlier bytes, or both. Thread-safe (no state).
#pragma once

#include <cstdint>
#include <span>

#include "roomcast/recording/lzfse/lz_output.h"

namespace roomcast::recording {

/// False: damaged, or there is no end in `payload`.
[[nodiscard]] bool decode_lzvn(std::span<const std::uint8_t> payload, LzOutput& out);

}  // namespace roomcast::recording
