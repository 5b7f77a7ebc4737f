// SPDX-License-Identifier: Apache-2.0
// Splits a fuzzer's input into messages of a hub: each has two bytes with its length in front.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace roomcast::fuzz {

using Bytes = std::span<const std::uint8_t>;

inline std::vector<Bytes> hub_messages(Bytes input) {
  constexpr std::size_t kLengthBytes = 2;
  std::vector<Bytes> messages;
  while (input.size() > kLengthBytes) {
    const std::size_t length = input[0] | input[1] << 8;
    input = input.subspan(kLengthBytes);
    const std::size_t size = std::min(length, input.size());
    messages.push_back(input.first(size));
    input = input.subspan(size);
  }
  return messages;
}

}  // namespace roomcast::fuzz
