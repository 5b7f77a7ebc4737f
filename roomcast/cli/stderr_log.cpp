// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/stderr_log.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>

#include "roomcast/cli/print.h"

namespace roomcast::cli {

LogSink counting_log(LogLine line, WriteLine write) {
  auto unwritten = std::make_shared<std::atomic<std::uint64_t>>(0);
  return [line = std::move(line), write = std::move(write), unwritten = std::move(unwritten)](
             LogLevel level, std::string_view message, LogFields fields) {
    const std::string text = line(level, message, fields);
    if (text.empty()) return;
    const std::uint64_t lost = unwritten->exchange(0);
    const std::string loss = fmt::format("{} lines before this one could not be written", lost);
    const bool told = lost == 0 || write(line(LogLevel::kWarning, loss, {}));
    if (!told) *unwritten += lost;
    if (!write(text)) ++*unwritten;
  };
}

LogSink stderr_log(std::string_view name, bool verbose) {
  return counting_log(
      [name = std::string(name), verbose](LogLevel level, std::string_view message, LogFields) {
        if (!verbose && level == LogLevel::kInfo) return std::string();
        return fmt::format("roomcast {}: {}\n", name, one_line(message));
      },
      [](std::string_view text) { return write_raw(stderr, printable(text)); });
}

}  // namespace roomcast::cli
