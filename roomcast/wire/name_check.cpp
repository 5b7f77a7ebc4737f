// SPDX-License-Identifier: Apache-2.0
#include "roomcast/wire/name_check.h"

#include <cstddef>
#include <string>

#include "roomcast/wire/limits.h"

namespace roomcast::wire {
namespace {

/// Length of the UTF-8 sequence at the start of `text`, 0 if it is not valid (RFC 3629).
std::size_t utf8_sequence_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  const std::size_t length = lead < 0x80   ? 1
                             : lead < 0xC2 ? 0
                             : lead < 0xE0 ? 2
                             : lead < 0xF0 ? 3
                             : lead < 0xF5 ? 4
                                           : 0;
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  const bool overlong = (lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xF0 && byte(1) < 0x90);
  const bool surrogate = lead == 0xED && byte(1) >= 0xA0;
  const bool beyond_unicode = lead == 0xF4 && byte(1) >= 0x90;
  return overlong || surrogate || beyond_unicode ? 0 : length;
}

bool is_control_character(std::string_view sequence) {
  const auto lead = static_cast<unsigned char>(sequence[0]);
  const bool c1 = lead == 0xC2 && static_cast<unsigned char>(sequence[1]) < 0xA0;
  return lead < 0x20 || lead == 0x7F || c1;
}

}  // namespace

Status check_text(std::string_view text, std::size_t max_bytes, std::string_view what) {
  if (text.size() > max_bytes) {
    return Error{ErrorCode::kTooLarge,
                 std::string(what) + " is longer than " + std::to_string(max_bytes) + " bytes"};
  }
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t length = utf8_sequence_length(rest);
    if (length == 0) return Error{ErrorCode::kMalformed, std::string(what) + " is not valid UTF-8"};
    if (is_control_character(rest.substr(0, length))) {
      return Error{ErrorCode::kMalformed, std::string(what) + " has control characters"};
    }
    rest.remove_prefix(length);
  }
  return {};
}

Status check_name(std::string_view name, std::string_view what) {
  return check_text(name, kMaxNameBytes, "the " + std::string(what) + "'s name");
}

}  // namespace roomcast::wire
