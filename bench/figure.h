// SPDX-License-Identifier: Apache-2.0
// Figure: one measured number of a bench, as tables and scripts name it. Plain data.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace roomcast::bench {

struct Figure {
  std::string name;
  std::string unit;
  double value = 0;
};

[[nodiscard]] inline nlohmann::ordered_json json_of(const std::vector<Figure>& figures) {
  auto json = nlohmann::ordered_json::array();
  for (const Figure& figure : figures)
    json.push_back({{"name", figure.name}, {"unit", figure.unit}, {"value", figure.value}});
  return json;
}

}  // namespace roomcast::bench
