// SPDX-License-Identifier: Apache-2.0
// Libraries do not print. What an operator should know goes to a LogSink that the program passes
// in: a line for people, and what it is about for programs that read logs.
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

/// {"room", "lab"}; one without a value is left out.
struct LogField {
  std::string_view key, value;
};
using LogFields = std::span<const LogField>;

/// May be empty. Called on the thread that has something to say; the text is one line without a
/// newline. Nothing is allocated for the fields: they hold for the call only.
class LogSink {
 public:
  LogSink() = default;
  /// What takes the fields, too.
  template <class Write>
  requires std::is_invocable_v<Write&, LogLevel, std::string_view, LogFields> LogSink(Write write)
      : write_(std::move(write)) {}  // NOLINT: implicit
  /// What is for people only.
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
