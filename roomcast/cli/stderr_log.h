// SPDX-License-Identifier: Apache-2.0
// Logs on stderr. A log whose disk is full or whose reader has gone loses lines, and nothing else:
// they are counted, and the next line that can be written is preceded by one that says how many.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "roomcast/core/log.h"

namespace roomcast::cli {

/// Makes one line, with its newline; empty: nothing is to be said.
using LogLine = std::function<std::string(LogLevel, std::string_view, LogFields)>;
/// False: the line could not be written.
using WriteLine = std::function<bool(std::string_view)>;

/// Thread-safe if `line` and `write` are.
[[nodiscard]] LogSink counting_log(LogLine line, WriteLine write);

/// Lines "roomcast NAME: ...": warnings and errors only, unless `verbose`.
[[nodiscard]] LogSink stderr_log(std::string_view name, bool verbose);

}  // namespace roomcast::cli
