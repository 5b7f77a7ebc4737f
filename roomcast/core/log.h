// SPDX-License-Identifier: Apache-2.0
// Libraries do not print. Messages for the operator go to a LogSink passed in by the program: one
// line of text for people, plus key-value fields for log parsers.
#pragma once

#include <concepts>
#include <functional>
#include <initializer_list>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>

namespace roomcast {

enum class LogLevel { kInfo, kWarning, kError };

/// {"room", "lab"}; a field without a value is left out.
struct LogField {
  std::string_view key, value;
};
using LogFields = std::span<const LogField>;

/// May be empty. Called on the thread that logs; the text is one line without a newline. The fields
/// are not copied: they are valid during the call only.
class LogSink {
 public:
  LogSink() = default;
  /// From a function that takes the fields, too.
  template <class Write>
  requires std::is_invocable_v<Write&, LogLevel, std::string_view, LogFields> LogSink(Write write)
      : write_(std::move(write)) {}  // NOLINT: implicit
  /// From a function that takes only the level and the line.
  template <class Write>
  requires std::is_invocable_v<Write&, LogLevel, std::string_view> &&
      (!std::same_as<Write, LogSink>)LogSink(Write write)  // NOLINT: implicit
      : write_([write = std::move(write)](LogLevel level, std::string_view line, LogFields) {
          write(level, line);
        }) {}

  explicit operator bool() const { return static_cast<bool>(write_); }
  void operator()(LogLevel level, std::string_view line,
                  std::initializer_list<LogField> fields = {}) const {
    write_(level, line, LogFields(fields.begin(), fields.size()));
  }

 private:
  std::function<void(LogLevel, std::string_view, LogFields)> write_;
};

}  // namespace roomcast
