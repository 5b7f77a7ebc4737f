// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/sensor_name.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

namespace roomcast::recording {
namespace {

constexpr std::size_t kMaxNameBytes = 48;  // leaves room for a number; sensors' names have up to 64

std::string legal(const std::string& text) {
  constexpr std::string_view kLegal =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.";
  std::string name;
  for (const char c : text) {
    const bool replaced = kLegal.find(c) == std::string_view::npos;
    if (replaced && (name.empty() || name.back() == '-')) continue;
    name += replaced ? '-' : c;
  }
  while (!name.empty() && (name.back() == '-' || name.back() == '.')) name.pop_back();
  while (!name.empty() && name.front() == '.') name.erase(0, 1);
  if (name.size() > kMaxNameBytes) name.resize(kMaxNameBytes);
  return name;
}

}  // namespace

std::string sensor_name(const std::string& wanted, const std::string& file) {
  if (std::string name = legal(wanted); !name.empty()) return name;
  if (std::string name = legal(std::filesystem::path(file).stem().string()); !name.empty())
    return name;
  return "sensor";
}

void make_unique(std::vector<std::string>& names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string name = names[i];
    const auto taken = [&](const std::string& candidate) {
      return std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), candidate) !=
             names.begin() + static_cast<std::ptrdiff_t>(i);
    };
    for (int number = 2; taken(names[i]); ++number) names[i] = name + "-" + std::to_string(number);
  }
}

}  // namespace roomcast::recording
