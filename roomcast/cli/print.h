// SPDX-License-Identifier: Apache-2.0
// The one place where the program writes to people: results on stdout, sentences on stderr. Nothing
// here throws: a reader who has gone or a full disk must not end a hub. Characters that steer a
// terminal or turn the direction of text, which foreign names and files may have, are shown as
// \u001B; JSON means the same with them.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace roomcast::cli {

/// Puts /dev/null where a standard stream is closed (`2>&-`): otherwise the next file or socket
/// that is opened would be taken for it. Writing to a closed stdout still fails.
void keep_standard_streams();

/// `text` with \u001B instead of control characters other than newline and tab, of marks that turn
/// the direction of text, and of invisible spaces; and with \x9B instead of bytes that are not
/// UTF-8.
[[nodiscard]] std::string printable(std::string_view text);

/// Likewise, and \u000A and \u0009 instead of newline and tab: a file's name that contains a
/// newline does not make two sentences of one.
[[nodiscard]] std::string one_line(std::string_view text);

/// As it is, in one piece. False: it could not be written, not even into a buffer.
bool write_raw(std::FILE* stream, std::string_view text) noexcept;

/// False: nobody can read it.
template <class... Args>
bool print_err(fmt::format_string<Args...> format, Args&&... args) {
  return write_raw(stderr, printable(fmt::format(format, std::forward<Args>(args)...)));
}

/// wrote_results() finds out whether it arrived.
template <class... Args>
void print_out(fmt::format_string<Args...> format, Args&&... args) {
  (void)write_raw(stdout, printable(fmt::format(format, std::forward<Args>(args)...)));
}

/// Whether everything on stdout so far could be written. To be asked at the end, in the thread that
/// wrote.
[[nodiscard]] bool wrote_results() noexcept;

}  // namespace roomcast::cli
