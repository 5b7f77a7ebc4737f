// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/csv_field.h"

#include <string_view>

namespace roomcast {
namespace {

std::string without_formula(const std::string& text) {
  constexpr std::string_view kBeginsFormula = "=+-@\t\r";
  const bool is_formula = !text.empty() && kBeginsFormula.find(text[0]) != std::string_view::npos;
  return is_formula ? "'" + text : text;
}

}  // namespace

std::string csv_field(const std::string& text) {
  const std::string field = without_formula(text);
  return field.find_first_of("\",\r\n'") == std::string::npos ? field : quoted_csv_field(text);
}

std::string quoted_csv_field(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : without_formula(text)) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + "\"";
}

}  // namespace roomcast
