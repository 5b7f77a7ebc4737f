// SPDX-License-Identifier: Apache-2.0
// WebSocketReader: parses incoming bytes into messages, pings, pongs and closes. Pure: no sockets,
// no time. Binary messages only, fragments joined, no extensions. Memory follows the bytes that
// have arrived, never a length that was only announced, and never exceeds the message limit.
// Source: RFC 6455 sections 5 (framing) and 7 (closing). Violations are refused with the close code
// of the RFC.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "roomcast/net/message_buffer.h"
#include "roomcast/net/websocket_frame.h"

namespace roomcast::net {

/// All bytes were consumed and no event is complete.
struct NeedsMoreBytes {};
struct Ping {
  std::string payload;
};
struct Pong {
  std::string payload;
};
/// The peer's close frame. Bytes after it are ignored.
struct PeerClose {
  std::uint16_t code = close_code::kNoCode;
  std::string reason;
};
/// The peer violated the protocol: close with `code`; `sentence` explains it. Nothing more can be
/// read.
struct Violation {
  std::uint16_t code = close_code::kProtocolError;
  std::string sentence;
};
/// MessageBuffer: a whole binary message, unmasked.
using ReaderEvent = std::variant<NeedsMoreBytes, MessageBuffer, Ping, Pong, PeerClose, Violation>;

class WebSocketReader {
 public:
  /// A server requires masked frames, a client unmasked ones.
  WebSocketReader(WebSocketRole role, std::size_t max_message_bytes)
      : role_(role), max_message_bytes_(max_message_bytes) {}

  /// The next event; removes the consumed bytes from the front of `bytes`. Call until
  /// NeedsMoreBytes. After PeerClose or Violation it always gives NeedsMoreBytes and discards the
  /// bytes.
  [[nodiscard]] ReaderEvent next(std::span<const std::uint8_t>& bytes);

  /// Valid from the next frame header on.
  void set_max_message_bytes(std::size_t bytes) { max_message_bytes_ = bytes; }

  /// Announced bytes of the frame in progress that have not arrived. For sizing the next read.
  [[nodiscard]] std::uint64_t missing_bytes() const { return missing_; }

 private:
  enum class State { kHeader, kPayload, kDone };

  bool fill_header(std::span<const std::uint8_t>& bytes, std::size_t size);
  [[nodiscard]] std::size_t header_size() const;
  [[nodiscard]] std::optional<Violation> fault_in_first_two_bytes() const;
  [[nodiscard]] std::optional<Violation> fault_in_order(Opcode opcode, bool final) const;
  [[nodiscard]] std::uint64_t announced_length() const;
  [[nodiscard]] std::optional<Violation> begin_frame();
  bool take_payload(std::span<const std::uint8_t>& bytes);
  void append_to_message(std::span<const std::uint8_t> came);
  [[nodiscard]] std::optional<ReaderEvent> end_frame();
  [[nodiscard]] ReaderEvent end_close(std::string_view payload);
  [[nodiscard]] ReaderEvent refuse(Violation violation);

  WebSocketRole role_;
  std::size_t max_message_bytes_;
  State state_ = State::kHeader;

  std::array<std::uint8_t, kMaxFrameHeader> header_{};
  std::size_t header_filled_ = 0;

  Opcode opcode_ = Opcode::kBinary;  // of the frame in progress
  bool final_ = false;
  MaskKey mask_{};
  std::size_t phase_ = 0;      // payload bytes of this frame already taken
  std::uint64_t missing_ = 0;  // payload bytes of this frame still to come

  bool in_message_ = false;  // a fragmented message has begun and not ended
  MessageBuffer message_;
  std::array<std::uint8_t, kMaxControlPayload> control_{};
};

}  // namespace roomcast::net
