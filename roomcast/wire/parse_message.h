// SPDX-License-Identifier: Apache-2.0
// Parses Protobuf messages without a word: for bytes that are no message, such as strings that are
// not UTF-8, libprotobuf would write lines of its own to stderr, so strangers could fill a hub's
// log, and a program that uses libroomcast would print what its author never wrote. Thread-safe.
#pragma once

#include <cstdint>
#include <span>

#include <google/protobuf/message_lite.h>
#include <google/protobuf/stubs/logging.h>

namespace roomcast::wire {

/// False: the bytes are no such message.
[[nodiscard]] inline bool parse_message(std::span<const std::uint8_t> bytes,
                                        google::protobuf::MessageLite& message) {
  const google::protobuf::LogSilencer silence;
  return message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()));
}

}  // namespace roomcast::wire
