// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/topic_name.h"

#include <algorithm>

namespace roomcast::recording {

std::size_t common_topic_parts(const std::string& a, const std::string& b) {
  std::size_t parts = 0;
  for (std::size_t i = 1; i <= std::min(a.size(), b.size()) && a[i - 1] == b[i - 1]; ++i) {
    const bool ends_a = i == a.size() || a[i] == '/', ends_b = i == b.size() || b[i] == '/';
    if (ends_a && ends_b) ++parts;
  }
  return parts;
}

std::string topic_above(const std::string& topic) {
  const std::size_t end = topic.rfind('/');
  return end == std::string::npos ? "" : topic.substr(0, end);
}

}  // namespace roomcast::recording
