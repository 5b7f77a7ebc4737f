// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/tls/fingerprint.h"

#include <cstddef>

#include "roomcast/core/hex_text.h"

namespace roomcast::net {

namespace {

std::optional<unsigned> hex_value(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return std::nullopt;
}

}  // namespace

std::string to_string(const Fingerprint& fingerprint) {
  return hex_text(fingerprint);
}

std::optional<Fingerprint> parse_fingerprint(std::string_view text) {
  Fingerprint fingerprint{};
  const bool colons = text.size() == 3 * fingerprint.size() - 1;
  if (!colons && text.size() != 2 * fingerprint.size()) return std::nullopt;
  for (std::size_t i = 0; i < fingerprint.size(); ++i) {
    const std::size_t at = i * (colons ? 3 : 2);
    const auto high = hex_value(text[at]), low = hex_value(text[at + 1]);
    if (!high || !low) return std::nullopt;
    if (colons && i + 1 < fingerprint.size() && text[at + 2] != ':') return std::nullopt;
    fingerprint[i] = static_cast<std::uint8_t>(*high << 4 | *low);
  }
  return fingerprint;
}

}  // namespace roomcast::net
