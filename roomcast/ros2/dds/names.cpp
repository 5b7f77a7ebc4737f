// SPDX-License-Identifier: Apache-2.0
#include "roomcast/ros2/dds/names.h"

#include <algorithm>

namespace roomcast::ros2 {
namespace {

constexpr std::size_t kMaxNameBytes = 240;  // 255 in DDS, with prefix and suffix

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c) || c == '_';
}

bool is_part(std::string_view part) {
  return !part.empty() && !is_digit(part.front()) && std::ranges::all_of(part, is_name_character);
}

}  // namespace

Status check_topic_name(std::string_view name) {
  bool is_name = name.starts_with('/') && name.size() <= kMaxNameBytes;
  for (std::string_view rest = name; is_name && !rest.empty();) {
    rest.remove_prefix(1);
    const std::size_t end = std::min(rest.find('/'), rest.size());
    is_name = is_part(rest.substr(0, end));
    rest.remove_prefix(end);
  }
  if (is_name) return {};
  return invalid_argument("\"" + std::string(name.substr(0, kMaxNameBytes)) +
                          "\" is not the name of a ROS 2 topic, such as /camera/depth/image_raw");
}

std::string dds_topic_name(std::string_view name) {
  return "rt" + std::string(name);
}

std::string dds_type_name(std::string_view type) {
  const std::size_t package_end = type.find('/'), name_begin = type.rfind('/') + 1;
  return std::string(type.substr(0, package_end)) +
         "::msg::dds_::" + std::string(type.substr(name_begin)) + "_";
}

std::string name_part(std::string_view text) {
  std::string part(text);
  std::ranges::replace_if(
      part, [](char c) { return !is_name_character(c); }, '_');
  if (part.empty() || is_digit(part.front())) part.insert(part.begin(), '_');
  return part;
}

}  // namespace roomcast::ros2
