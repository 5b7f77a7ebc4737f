// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/time_span.h"

#include <array>
#include <charconv>

namespace roomcast::cli {

namespace {

struct Unit {
  char letter;
  std::int64_t seconds;
};
constexpr std::array<Unit, 4> kUnits = {{{'d', 86'400}, {'h', 3'600}, {'m', 60}, {'s', 1}}};
constexpr std::int64_t kMaxCount = 100'000;  // largest count of any unit

}  // namespace

Result<std::int64_t> parse_time_span(std::string_view text) {
  std::int64_t number = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool one_letter_left = end + 1 == text.data() + text.size();
  if (fault == std::errc() && one_letter_left && number > 0 && number <= kMaxCount) {
    for (const Unit& unit : kUnits) {
      if (unit.letter == *end) return number * unit.seconds;
    }
  }
  return Error{ErrorCode::kInvalidArgument,
               "\"" + std::string(text) + "\" is not a time span; write 90s, 30m, 8h or 7d"};
}

std::string format_time_span(std::int64_t seconds) {
  for (const Unit& unit : kUnits) {
    if (seconds >= 2 * unit.seconds || unit.seconds == 1 || seconds == unit.seconds) {
      return std::to_string(seconds / unit.seconds) + unit.letter;
    }
  }
  return "0s";
}

}  // namespace roomcast::cli
