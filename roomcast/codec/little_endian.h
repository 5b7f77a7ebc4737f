// SPDX-License-Identifier: Apache-2.0
// Little-endian numbers in byte arrays. The caller has checked that the bytes are there.
#pragma once

#include <cstdint>
#include <vector>

namespace roomcast::codec {

[[nodiscard]] inline std::uint32_t read_u16(const std::uint8_t* bytes) {
  return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8;
}

[[nodiscard]] inline std::uint32_t read_u32(const std::uint8_t* bytes) {
  return read_u16(bytes) | read_u16(bytes + 2) << 16;
}

inline void write_u16(std::uint8_t* bytes, std::uint32_t value) {
  bytes[0] = static_cast<std::uint8_t>(value);
  bytes[1] = static_cast<std::uint8_t>(value >> 8);
}

inline void write_u32(std::uint8_t* bytes, std::uint32_t value) {
  write_u16(bytes, value & 0xFFFF);
  write_u16(bytes + 2, value >> 16);
}

}  // namespace roomcast::codec
