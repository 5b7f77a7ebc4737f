// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/access/one_time_code.h"

#include <cctype>
#include <span>

#include "roomcast/core/hex_text.h"
#include "roomcast/net/random_bytes.h"

namespace roomcast::hub {

namespace {

constexpr std::string_view kDigits = "0123456789ABCDEFGHJKMNPQRSTVWXYZ";
constexpr std::size_t kLength = 16, kGroup = 4;

/// Corrects a typed letter to the digit that was meant; 0: not allowed in a code.
char as_meant(char letter) {
  const char upper = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  if (upper == 'O') return '0';
  if (upper == 'I' || upper == 'L') return '1';
  return kDigits.find(upper) != std::string_view::npos ? upper : '\0';
}

}  // namespace

std::string make_one_time_code() {
  std::array<std::uint8_t, kLength> random{};
  net::fill_with_random_bytes(random);
  std::string code;
  for (std::size_t i = 0; i < kLength; ++i) {
    if (i > 0 && i % kGroup == 0) code += '-';
    code += kDigits[random[i] % kDigits.size()];
  }
  return code;
}

std::optional<CodeDigest> digest_of_code(std::string_view code) {
  std::string plain;
  for (const char letter : code) {
    if (letter == '-' || letter == ' ') continue;
    const char meant = as_meant(letter);
    if (meant == '\0' || plain.size() == kLength) return std::nullopt;
    plain += meant;
  }
  if (plain.size() != kLength) return std::nullopt;
  return sha256_of(plain);
}

std::string id_of_code(const CodeDigest& digest) {
  constexpr std::size_t kShown = 8;
  return "code-" + hex_text(std::span(digest).first<kShown>());
}

std::string make_token_id() {
  std::array<std::uint8_t, 16> random{};
  net::fill_with_random_bytes(random);
  return hex_text(random);
}

}  // namespace roomcast::hub
