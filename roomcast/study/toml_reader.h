// SPDX-License-Identifier: Apache-2.0
// TomlReader: reads values of a TOML file and collects what is wrong with them, each with its line,
// so that a person is told everything at once. Single-threaded. Include it in .cpp files only: it
// brings all of toml++.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#define TOML_EXCEPTIONS 0
#define TOML_HEADER_ONLY 1  // Debian's library build throws exceptions
#include <toml++/toml.h>

#include "roomcast/study/plan.h"

namespace roomcast::study {

[[nodiscard]] std::size_t line_of(const toml::node& node);

class TomlReader {
 public:
  /// What may stand in a table; each reader reports what is wrong itself.
  using Readers = std::map<std::string_view, std::function<void(const toml::node&)>>;

  void fault(std::size_t line, std::string sentence) {
    faults_.push_back({line, std::move(sentence)});
  }
  void read_table(const toml::table& table, const std::string& what, const Readers& readers);
  void need(const toml::table& table, const std::string& what, const char* key);
  void each_table(const toml::node& node, const std::string& what, std::size_t most,
                  const std::function<void(const toml::table&)>& read);

  void text(const toml::node& node, std::string& into);
  void plain_name(const toml::node& node, std::string& into);
  void flag(const toml::node& node, bool& into);
  void number(const toml::node& node, double least, double most, double& into);
  void texts(const toml::node& node, std::vector<std::string>& into);
  template <class T>
  void one_of(const toml::node& node, const std::vector<std::pair<std::string_view, T>>& names,
              T& into);

  /// All that was wrong, in order of lines.
  [[nodiscard]] std::vector<PlanFault> take_faults();

 private:
  std::vector<PlanFault> faults_;
};

template <class T>
void TomlReader::one_of(const toml::node& node,
                        const std::vector<std::pair<std::string_view, T>>& names, T& into) {
  const auto value = node.value_exact<std::string>();
  std::string all;
  for (const auto& [name, meaning] : names) {
    if (value && *value == name) {
      into = meaning;
      return;
    }
    all += (all.empty() ? "\"" : ", \"") + std::string(name) + "\"";
  }
  fault(line_of(node), "this must be one of " + all);
}

}  // namespace roomcast::study
