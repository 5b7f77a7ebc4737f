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

std::optional<nanoseconds> read_utc_text(const std::string& text) {
  std::tm parts{};
  const char* rest = ::strptime(text.c_str(), "%Y-%m-%dT%H:%M:%S", &parts);
  if (rest == nullptr) return std::nullopt;
  std::int64_t fraction_ns = 0, unit_ns = 1'000'000'000;
  if (*rest == '.') {
    for (++rest; *rest >= '0' && *rest <= '9'; ++rest) {
      unit_ns /= 10;
      fraction_ns += (*rest - '0') * unit_ns;
    }
  }
  if (*rest != 'Z' || rest[1] != '\0') return std::nullopt;
  return std::chrono::seconds(::timegm(&parts)) + nanoseconds(fraction_ns);
}

}  // namespace roomcast
