// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/utf8.h"

#include <cstddef>
#include <cstdint>

namespace roomcast::net {

namespace {

struct Lead {
  std::size_t length = 0;          // of the whole character; 0 = not a lead byte
  std::uint8_t second_min = 0x80;  // excludes overlong forms and surrogates
  std::uint8_t second_max = 0xBF;
};

Lead classify(std::uint8_t byte) {
  if (byte <= 0x7F) return {1};
  if (byte >= 0xC2 && byte <= 0xDF) return {2};
  if (byte == 0xE0) return {3, 0xA0, 0xBF};
  if (byte == 0xED) return {3, 0x80, 0x9F};
  if (byte >= 0xE1 && byte <= 0xEF) return {3};
  if (byte == 0xF0) return {4, 0x90, 0xBF};
  if (byte >= 0xF1 && byte <= 0xF3) return {4};
  if (byte == 0xF4) return {4, 0x80, 0x8F};
  return {0};
}

}  // namespace

bool is_utf8(std::string_view text) {
  const auto byte_at = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  for (std::size_t i = 0; i < text.size();) {
    const Lead lead = classify(byte_at(i));
    if (lead.length == 0 || i + lead.length > text.size()) return false;
    for (std::size_t k = 1; k < lead.length; ++k) {
      const std::uint8_t min = k == 1 ? lead.second_min : 0x80;
      const std::uint8_t max = k == 1 ? lead.second_max : 0xBF;
      if (byte_at(i + k) < min || byte_at(i + k) > max) return false;
    }
    i += lead.length;
  }
  return true;
}

}  // namespace roomcast::net
