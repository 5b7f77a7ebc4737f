// SPDX-License-Identifier: Apache-2.0
#include "roomcast/study/toml_reader.h"

#include <fmt/format.h>

namespace roomcast::study {
namespace {

constexpr std::size_t kMaxNameBytes = 64;

bool is_plain_name(const std::string& name) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_';
  };
  return !name.empty() && name.size() <= kMaxNameBytes && std::ranges::all_of(name, is_plain);
}

}  // namespace

std::size_t line_of(const toml::node& node) {
  return node.source().begin.line;
}

std::vector<PlanFault> TomlReader::take_faults() {
  std::ranges::stable_sort(faults_, {}, &PlanFault::line);
  return std::move(faults_);
}

void TomlReader::read_table(const toml::table& table, const std::string& what,
                            const Readers& readers) {
  for (const auto& [key, node] : table) {
    const auto reader = readers.find(key.str());
    if (reader != readers.end()) {
      reader->second(node);
      continue;
    }
    std::string known;
    for (const auto& [name, read] : readers)
      known += (known.empty() ? "" : ", ") + std::string(name);
    fault(key.source().begin.line,
          fmt::format("{} has no \"{}\"; it may have: {}", what, std::string(key.str()), known));
  }
}

void TomlReader::need(const toml::table& table, const std::string& what, const char* key) {
  if (!table.contains(key)) fault(line_of(table), fmt::format("{} needs \"{}\"", what, key));
}

void TomlReader::each_table(const toml::node& node, const std::string& what, std::size_t most,
                            const std::function<void(const toml::table&)>& read) {
  const toml::array* list = node.as_array();
  const bool are_tables = list != nullptr && std::ranges::all_of(*list, [](const toml::node& one) {
                            return one.is_table();
                          });
  if (!are_tables)
    return fault(line_of(node),
                 fmt::format("write each {} as [[{}]] on a line of its own", what, what));
  if (list->size() > most)
    return fault(line_of((*list)[most]), fmt::format("there are more than {} of {}", most, what));
  for (const toml::node& one : *list) read(*one.as_table());
}

void TomlReader::text(const toml::node& node, std::string& into) {
  const auto value = node.value_exact<std::string>();
  if (!value) return fault(line_of(node), "this must be text in quotation marks");
  if (value->size() > kMaxTextBytes)
    return fault(line_of(node), fmt::format("this text is longer than {} bytes", kMaxTextBytes));
  into = *value;
}

void TomlReader::plain_name(const toml::node& node, std::string& into) {
  text(node, into);
  if (node.is_string() && !is_plain_name(into))
    fault(line_of(node),
          fmt::format("\"{}\" is no name: it takes 1 to 64 letters, digits, - and _", into));
}

void TomlReader::flag(const toml::node& node, bool& into) {
  const auto value = node.value_exact<bool>();
  if (!value) return fault(line_of(node), "this must be true or false");
  into = *value;
}

void TomlReader::number(const toml::node& node, double least, double most, double& into) {
  const auto value = node.is_number() ? node.value<double>() : std::nullopt;
  if (!value || !(*value >= least && *value <= most))
    return fault(line_of(node),
                 fmt::format("this must be a number from {:g} to {:g}", least, most));
  into = *value;
}

void TomlReader::texts(const toml::node& node, std::vector<std::string>& into) {
  const toml::array* list = node.as_array();
  if (list == nullptr) return fault(line_of(node), "this must be a list of texts: [\"a\", \"b\"]");
  into.clear();
  for (const toml::node& one : *list) text(one, into.emplace_back());
}

}  // namespace roomcast::study
