// SPDX-License-Identifier: Apache-2.0
// Little-endian numbers in byte arrays. The caller has checked that enough bytes are available.
#pragma once

#include <cstdint>

namespace roomcast {

[[nodiscard]] inline std::uint16_t read_u16(const std::uint8_t* bytes) {
  return static_cast<std::uint16_t>(bytes[0] | bytes[1] << 8);
}

[[nodiscard]] inline std::uint32_t read_u32(const std::uint8_t* bytes) {
  return read_u16(bytes) | std::uint32_t{read_u16(bytes + 2)} << 16;
}

[[nodiscard]] inline std::uint64_t read_u64(const std::uint8_t* bytes) {
  return read_u32(bytes) | std::uint64_t{read_u32(bytes + 4)} << 32;
}

inline void write_u16(std::uint8_t* bytes, std::uint16_t value) {
  bytes[0] = static_cast<std::uint8_t>(value);
  bytes[1] = static_cast<std::uint8_t>(value >> 8);
}

inline void write_u32(std::uint8_t* bytes, std::uint32_t value) {
  write_u16(bytes, static_cast<std::uint16_t>(value));
  write_u16(bytes + 2, static_cast<std::uint16_t>(value >> 16));
}

inline void write_u64(std::uint8_t* bytes, std::uint64_t value) {
  write_u32(bytes, static_cast<std::uint32_t>(value));
  write_u32(bytes + 4, static_cast<std::uint32_t>(value >> 32));
}

}  // namespace roomcast
