// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/utc_text.h"

#include <array>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <ctime>

namespace roomcast {

std::string utc_text(nanoseconds unix_time) {
  const auto seconds = static_cast<std::time_t>(unix_time.count() / 1'000'000'000);
  std::tm parts{};
  ::gmtime_r(&seconds, &parts);
  std::array<char, 48> text{};
  const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%S", &parts);
  std::snprintf(text.data() + length, text.size() - length, ".%09" PRId64 "Z",
                static_cast<std::int64_t>(unix_time.count() % 1'000'000'000));
  return text.data();
}

}  // namespace roomcast
