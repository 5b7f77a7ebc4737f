// SPDX-License-Identifier: Apache-2.0
// Appends text and numbers, the least significant byte first, to the bytes of a file. Thread-safe
// (no state).
#pragma once

#include <bit>
#include <cstdint>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace roomcast::recording {

inline void append_text(std::string_view text, std::vector<std::uint8_t>& out) {
  out.insert(out.end(), text.begin(), text.end());
}
inline void append_u16(std::uint16_t value, std::vector<std::uint8_t>& out) {
  out.push_back(static_cast<std::uint8_t>(value));
  out.push_back(static_cast<std::uint8_t>(value >> 8U));
}
inline void append_u32(std::uint32_t value, std::vector<std::uint8_t>& out) {
  for (unsigned shift = 0; shift < 32; shift += 8)
    out.push_back(static_cast<std::uint8_t>(value >> shift));
}
inline void append_float(float value, std::vector<std::uint8_t>& out) {
  append_u32(std::bit_cast<std::uint32_t>(value), out);
}
inline void append_floats(const Eigen::Vector3f& vector, std::vector<std::uint8_t>& out) {
  for (int i = 0; i < 3; ++i) append_float(vector[i], out);
}

}  // namespace roomcast::recording
