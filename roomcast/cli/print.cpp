// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/print.h"

#include <algorithm>
#include <cerrno>
#include <iostream>

#include <fcntl.h>
#include <unistd.h>

namespace roomcast::cli {
namespace {

/// One character of UTF-8; `length` 0: the bytes are none.
struct Character {
  char32_t code = 0;
  std::size_t length = 0;
};

Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return {first, 1};
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) return {};
  char32_t code = first & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0u) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3Fu);
  }
  return {code, length};
}

/// Steers a terminal, turns the direction of text (Unicode's Bidi_Control), or cannot be seen.
bool is_unsafe(char32_t code) {
  if (code == U'\n' || code == U'\t') return false;
  const bool is_control = code < 0x20 || (code >= 0x7F && code <= 0x9F);
  const bool turns_text = code == 0x061C || code == 0x200E || code == 0x200F ||
                          (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
  return is_control || turns_text || code == 0x200B || code == 0x2060 || code == 0xFEFF;
}

bool is_plain(char c) {
  return (c >= ' ' && c < 0x7F) || c == '\n' || c == '\t';
}

}  // namespace

void keep_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) != -1 || errno != EBADF) continue;
    // The lowest free descriptor is this one. Reading only: a write fails as it did before.
    (void)!::open("/dev/null", O_RDONLY);
  }
}

std::string printable(std::string_view text) {
  if (std::ranges::all_of(text, is_plain)) return std::string(text);
  std::string shown;
  while (!text.empty()) {
    const Character next = first_character(text);
    const std::size_t length = std::max<std::size_t>(next.length, 1);
    if (next.length == 0) {
      shown += fmt::format("\\x{:02X}", static_cast<unsigned char>(text[0]));
    } else if (is_unsafe(next.code)) {
      shown += fmt::format("\\u{:04X}", static_cast<std::uint32_t>(next.code));
    } else {
      shown += text.substr(0, length);
    }
    text.remove_prefix(length);
  }
  return shown;
}

std::string one_line(std::string_view text) {
  std::string line;
  for (const char character : printable(text)) {
    if (character == '\n' || character == '\t') {
      line += fmt::format("\\u{:04X}", static_cast<int>(character));
    } else {
      line += character;
    }
  }
  return line;
}

bool write_raw(std::FILE* stream, std::string_view text) noexcept {
  return std::fwrite(text.data(), 1, text.size(), stream) == text.size();
}

bool wrote_results() noexcept {
  std::cout.flush();
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good();
}

}  // namespace roomcast::cli
