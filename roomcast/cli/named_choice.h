// SPDX-License-Identifier: Apache-2.0
// An option that takes one of several named values; --help lists the names.
#pragma once

#include <map>
#include <string>

#include <CLI/CLI.hpp>

namespace roomcast::cli {

template <class Value>
CLI::Option* choose_by_name(CLI::Option* option, const std::map<std::string, Value>& names) {
  std::string all;
  for (const auto& [name, value] : names) all += (all.empty() ? "" : "|") + name;
  const auto number_of = [names, all](std::string& value) {
    const auto found = names.find(value);
    if (found == names.end()) return value + " is none of " + all;
    value = std::to_string(static_cast<int>(found->second));
    return std::string();
  };
  return option->transform(CLI::Validator(number_of, ""))->type_name(all);
}

}  // namespace roomcast::cli
