// SPDX-License-Identifier: Apache-2.0
// Log lines for programs: one JSON object a line on stderr, with time, level, program and message,
// and what the line is about under keys of its own (docs/guides/hub.md).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "roomcast/core/log.h"

namespace roomcast::cli {

/// `{"time":"2026-01-02T03:04:05.678Z","level":"info","program":"hub","message":"...","room":"lab"}`;
/// a field may not replace one of the first four.
[[nodiscard]] std::string json_log_line(std::string_view program, LogLevel level,
                                        std::string_view message, LogFields fields,
                                        std::int64_t unix_ms);

/// All levels.
[[nodiscard]] LogSink json_log(std::string_view program);

}  // namespace roomcast::cli
