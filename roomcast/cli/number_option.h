// SPDX-License-Identifier: Apache-2.0
// Checks of numbers on the command line. Unlike CLI11's own (CLI::Range and its like) they refuse
// "nan", and say in few digits what is allowed.
#pragma once

#include <charconv>
#include <cstdint>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace roomcast::cli {

/// Longer than any recording: thirty years.
inline constexpr double kLongest_s = 1e9;

/// A number from `min` to `max`.
template <class Number>
[[nodiscard]] CLI::Validator within(Number min, Number max) {
  const auto check = [min, max](const std::string& text) -> std::string {
    Number value{};
    // Written so that a value without an order, which nan is, fails.
    if (CLI::detail::lexical_cast(text, value) && value >= min && value <= max) return "";
    return fmt::format("{} is not a number from {:g} to {:g}", text, static_cast<double>(min),
                       static_cast<double>(max));
  };
  return {check, fmt::format("{:g} to {:g}", static_cast<double>(min), static_cast<double>(max))};
}

/// A span of time in seconds, 0 included.
[[nodiscard]] inline CLI::Validator seconds_from_zero() {
  return within(0.0, kLongest_s);
}

/// A span of time that is not over at once, in seconds.
[[nodiscard]] inline CLI::Validator some_seconds() {
  constexpr double kShortest_s = 1e-3;
  return within(kShortest_s, kLongest_s);
}

/// A whole number from 0 to 2^64 - 1, in digits only; CLI11 takes -1 for the largest one.
[[nodiscard]] inline CLI::Validator seed_number() {
  const auto check = [](const std::string& text) -> std::string {
    std::uint64_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    if (error == std::errc() && rest == end) return "";
    return text + " is not a whole number from 0 to 18446744073709551615";
  };
  return {check, ""};
}

}  // namespace roomcast::cli
