// SPDX-License-Identifier: Apache-2.0
// Prediction errors as tokens: each small error has its own token; larger errors share tokens and
// add plain bits. docs/spec/codec.md §2.2.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "roomcast/codec/lossless/frequency_table.h"

namespace roomcast::codec {

inline constexpr int kHoleToken = 0;
inline constexpr int kDirectTokens = 32;
inline constexpr int kFirstSharedToken = 1 + kDirectTokens;
inline constexpr int kFirstSharedExponent = 5;

/// `base` plus `extra_bits` plain bits is the error folded to a non-negative number: 0, -1, 1,
/// -2, 2...
struct TokenMeaning {
  std::uint16_t base = 0;
  std::uint8_t extra_bits = 0;
};

[[nodiscard]] constexpr std::array<TokenMeaning, 128> token_meanings() {
  std::array<TokenMeaning, 128> meanings{};
  for (int t = 1; t < kTokenCount; ++t) {
    if (t < kFirstSharedToken) {
      meanings[t].base = static_cast<std::uint16_t>(t - 1);
      continue;
    }
    const int j = t - kFirstSharedToken;
    const int extra_bits = kFirstSharedExponent + j / 4 - 2;
    meanings[t].extra_bits = static_cast<std::uint8_t>(extra_bits);
    meanings[t].base = static_cast<std::uint16_t>((4 + j % 4) << extra_bits);
  }
  return meanings;
}
inline constexpr auto kTokenMeanings = token_meanings();

[[nodiscard]] constexpr int token_of(std::uint32_t folded) {
  if (folded < kDirectTokens) return 1 + static_cast<int>(folded);
  const int n = static_cast<int>(std::bit_width(folded)) - 1;
  return kFirstSharedToken + (n - kFirstSharedExponent) * 4 +
         static_cast<int>((folded >> (n - 2)) & 3);
}
static_assert(token_of(65535) == kTokenCount - 1);

inline constexpr std::uint32_t kTabledErrors = 1024;
[[nodiscard]] constexpr std::array<std::uint8_t, kTabledErrors> token_table() {
  std::array<std::uint8_t, kTabledErrors> table{};
  for (std::uint32_t folded = 0; folded < kTabledErrors; ++folded) {
    table[folded] = static_cast<std::uint8_t>(token_of(folded));
  }
  return table;
}
inline constexpr auto kTokens = token_table();

/// token_of without an unpredictable branch.
[[nodiscard]] inline int quick_token_of(std::uint32_t folded) {
  return folded < kTabledErrors ? kTokens[folded] : token_of(folded);
}

[[nodiscard]] constexpr std::uint32_t fold(std::int16_t error) {
  return static_cast<std::uint16_t>(static_cast<std::uint32_t>(error) << 1 ^
                                    static_cast<std::uint32_t>(error >> 15));
}
[[nodiscard]] constexpr std::int32_t unfold(std::uint32_t folded) {
  return static_cast<std::int32_t>(folded >> 1) ^ -static_cast<std::int32_t>(folded & 1);
}
static_assert(unfold(fold(-32768)) == -32768 && unfold(fold(32767)) == 32767);

}  // namespace roomcast::codec
