// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/json_log.h"

#include <chrono>
#include <ctime>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "roomcast/cli/print.h"
#include "roomcast/cli/stderr_log.h"

namespace roomcast::cli {

namespace {

const char* name_of(LogLevel level) {
  if (level == LogLevel::kInfo) return "info";
  return level == LogLevel::kWarning ? "warning" : "error";
}

}  // namespace

std::string json_log_line(std::string_view program, LogLevel level, std::string_view message,
                          LogFields fields, std::int64_t unix_ms) {
  const auto seconds = static_cast<std::time_t>(unix_ms / 1000);
  nlohmann::ordered_json line;
  line["time"] = fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime(seconds), unix_ms % 1000);
  line["level"] = name_of(level);
  line["program"] = program;
  line["message"] = message;
  for (const auto& [key, value] : fields) {
    if (!value.empty()) line.emplace(key, value);  // emplace leaves an existing key unchanged
  }
  return line.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

LogSink json_log(std::string_view program) {
  return counting_log(
      [program = std::string(program)](LogLevel level, std::string_view message, LogFields fields) {
        const auto now = std::chrono::system_clock::now().time_since_epoch();
        const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(now).count();
        return json_log_line(program, level, message, fields, ms) + '\n';
      },
      [](std::string_view line) { return write_raw(stderr, printable(line)); });
}

}  // namespace roomcast::cli
