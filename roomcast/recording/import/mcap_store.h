// SPDX-License-Identifier: Apache-2.0
// The messages of an MCAP file (with chunks) that are in Protobuf. Single-threaded.
#pragma once

#include <filesystem>
#include <memory>

#include "roomcast/recording/import/message_store.h"

namespace roomcast::recording {

inline constexpr const char* kProtobufEncoding = "protobuf";  // of a channel, as MCAP names it

/// Errors of mcap::Reader::open, and kUnsupported: no messages in Protobuf; kTooLarge. Messages
/// name the file.
[[nodiscard]] Result<std::shared_ptr<MessageStore>> open_protobuf_store(
    const std::filesystem::path& path);

}  // namespace roomcast::recording
