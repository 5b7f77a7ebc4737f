// SPDX-License-Identifier: Apache-2.0
// Reads a number that is a part of a request's path. Thread-safe (no state).
#pragma once

#include <charconv>
#include <concepts>
#include <optional>
#include <string_view>
#include <system_error>

namespace roomcast::hub {

/// Nothing: it is not all digits, or too large.
template <std::unsigned_integral Number>
[[nodiscard]] std::optional<Number> path_number(std::string_view text) {
  Number number = 0;
  const char* const end = text.data() + text.size();
  const auto [read_to, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || read_to != end) return std::nullopt;
  return number;
}

}  // namespace roomcast::hub
