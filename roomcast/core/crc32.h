// SPDX-License-Identifier: Apache-2.0
// CRC-32 (ISO-HDLC, as in PNG, zlib, IEEE 802.3): reflected polynomial 0xEDB88320. For comparing
// pictures across processes and languages; not a protection against forgery.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace roomcast {

/// CRC of `bytes`; to continue a running CRC, pass the CRC of the preceding bytes as `before`.
[[nodiscard]] std::uint32_t crc32(std::span<const std::byte> bytes, std::uint32_t before = 0);

}  // namespace roomcast
