// SPDX-License-Identifier: Apache-2.0
// FramedMessage: one immutable WebSocket frame, header included, ready for the socket. A server's
// frames are not masked, so one framed message is written to all viewers from the same memory.
// Threading: immutable, share freely.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "roomcast/net/message_buffer.h"
#include "roomcast/net/websocket_frame.h"

namespace roomcast::net {

class FramedMessage;
using FramedMessagePtr = std::shared_ptr<const FramedMessage>;

class FramedMessage {
  struct Private {
    explicit Private() = default;
  };

 public:
  /// Header and payload as sent over the network.
  [[nodiscard]] std::span<const std::uint8_t> wire_bytes() const {
    return std::span(storage_).subspan(start_);
  }
  /// The payload alone; masked if the message was framed with a mask.
  [[nodiscard]] std::span<const std::uint8_t> payload() const {
    return std::span(storage_).subspan(MessageBuffer::kHeadroom);
  }
  [[nodiscard]] std::size_t size() const { return payload().size(); }

  /// Use the functions below instead.
  FramedMessage(Private, std::vector<std::uint8_t> storage, std::size_t start)
      : storage_(std::move(storage)), start_(start) {}

 private:
  friend FramedMessagePtr frame_message(MessageBuffer&& message, Opcode opcode,
                                        std::optional<MaskKey> mask);

  std::vector<std::uint8_t> storage_;
  std::size_t start_;  // of the header within storage_
};

/// Puts the header in front of the payload without moving it; with a `mask`, masks the payload in
/// place. Control frames (ping, pong, close) contain at most kMaxControlPayload bytes.
[[nodiscard]] FramedMessagePtr frame_message(MessageBuffer&& message,
                                             Opcode opcode = Opcode::kBinary,
                                             std::optional<MaskKey> mask = std::nullopt);

/// A masked copy of an unmasked binary message, as sent by a client.
[[nodiscard]] FramedMessagePtr frame_masked_copy(const FramedMessage& message, MaskKey mask);

}  // namespace roomcast::net
