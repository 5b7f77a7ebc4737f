// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/option_fields.h"

#include <array>
#include <charconv>

namespace roomcast {
namespace {

/// The shortest decimal form without an exponent.
std::string text_of(double number) {
  std::array<char, 400> text{};  // the largest double has 309 digits
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed).ptr;
  return {text.data(), end};
}

std::string path_of(std::string_view options, std::string_view field) {
  return std::string(options) + "." + std::string(field);
}

}  // namespace

Status check_field(std::string_view options, std::string_view field, double value, Range range) {
  if (value >= range.least && value <= range.most) return {};  // refuses NaN
  return invalid_argument(path_of(options, field) + " must be " + text_of(range.least) + ".." +
                          text_of(range.most));
}

Status check_at_most(std::string_view options, std::string_view field, double value,
                     std::string_view other, double other_value) {
  if (value <= other_value) return {};
  return invalid_argument(path_of(options, field) + " must be at most " + std::string(other));
}

}  // namespace roomcast
