// SPDX-License-Identifier: Apache-2.0
// Machine-readable log: one JSON object per line on stderr, with time, level, program and message.
// The subjects of a line (room, sensor, ...) have keys of their own (docs/guides/hub.md).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "roomcast/core/log.h"

namespace roomcast::cli {

/// `{"time":"2026-01-02T03:04:05.678Z","level":"info","program":"hub","message":"...","room":"lab"}`;
/// a field cannot replace one of the first four.
[[nodiscard]] std::string json_log_line(std::string_view program, LogLevel level,
                                        std::string_view message, LogFields fields,
                                        std::int64_t unix_ms);

/// Logs all levels.
[[nodiscard]] LogSink json_log(std::string_view program);

}  // namespace roomcast::cli
