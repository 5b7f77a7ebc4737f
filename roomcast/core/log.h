// SPDX-License-Identifier: Apache-2.0
// Libraries do not print. What an operator should know goes to a LogSink that the program passes
// in.
#pragma once

#include <functional>
#include <string_view>

namespace roomcast {

enum class LogLevel { kInfo, kWarning, kError };

/// May be empty. Called on the thread that has something to say; the text is one line without a
/// newline.
using LogSink = std::function<void(LogLevel, std::string_view)>;

}  // namespace roomcast
