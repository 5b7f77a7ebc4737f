// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/align/pair_list.h"

#include <nlohmann/json.hpp>

#include "roomcast/io/json_fields.h"

namespace roomcast::recording {
namespace {

std::optional<std::string> name_of(const nlohmann::json& pair, const char* field) {
  const auto found = pair.find(field);
  if (found == pair.end()) return std::nullopt;
  if (found->is_string()) return found->get<std::string>();
  if (found->is_number_unsigned()) return std::to_string(found->get<std::uint64_t>());
  return std::nullopt;
}

/// Accepts four rows of four numbers, or sixteen numbers in one row.
std::vector<double> numbers_of(const nlohmann::json& value) {
  std::vector<double> numbers;
  for (const auto& item : value) {
    if (item.is_number()) numbers.push_back(item.get<double>());
    if (!item.is_array()) continue;
    for (const auto& number : item) {
      if (number.is_number()) numbers.push_back(number.get<double>());
    }
  }
  return numbers;
}

Result<ListedPair> read_pair(const nlohmann::json& json) {
  const Error malformed{ErrorCode::kMalformed,
                        "must be an object with a and b, frame numbers or sensor names"};
  if (!json.is_object()) return malformed;
  const auto a = name_of(json, "a"), b = name_of(json, "b");
  if (!a || !b) return malformed;
  ListedPair pair{*a, *b, std::nullopt, std::nullopt};
  if (json.contains("T_b_from_a")) {
    const auto transform = transform_from_row_major(numbers_of(json["T_b_from_a"]));
    if (!transform)
      return Error{ErrorCode::kMalformed, "has a T_b_from_a that is not a rigid transform"};
    pair.b_from_a = *transform;
  }
  if (json.contains("overlap") && json["overlap"].is_number()) {
    pair.overlap = json["overlap"].get<double>();
  }
  return pair;
}

}  // namespace

Result<std::vector<ListedPair>> read_pair_list(const std::filesystem::path& path) {
  const auto json = io::read_json_object(path);
  if (!json) return json.error();
  const auto listed = json->find("pairs");
  if (listed == json->end() || !listed->is_array() || listed->size() > kMaxListedPairs) {
    return Error{ErrorCode::kMalformed, path.string() + " has no list \"pairs\""};
  }
  std::vector<ListedPair> pairs;
  for (const auto& item : *listed) {
    auto pair = read_pair(item);
    if (!pair) {
      return Error{ErrorCode::kMalformed, path.string() + ": pair " + std::to_string(pairs.size()) +
                                              " " + pair.error().message};
    }
    pairs.push_back(std::move(*pair));
  }
  return pairs;
}

}  // namespace roomcast::recording
