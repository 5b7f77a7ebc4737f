// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/websocket_reader.h"

#include <algorithm>
#include <utility>

#include "roomcast/net/utf8.h"

namespace roomcast::net {

namespace {

constexpr std::uint8_t kReservedBits = 0x70;
constexpr std::uint8_t kOpcodeBits = 0x0F;
constexpr std::uint8_t kLengthBits = 0x7F;
constexpr std::uint8_t kLength16 = 126;
constexpr std::uint8_t kLength64 = 127;

bool is_known(Opcode opcode) {
  switch (opcode) {
    case Opcode::kContinuation:
    case Opcode::kText:
    case Opcode::kBinary:
    case Opcode::kClose:
    case Opcode::kPing:
    case Opcode::kPong:
      return true;
  }
  return false;
}

Violation protocol_error(std::string sentence) {
  return {close_code::kProtocolError, std::move(sentence)};
}

}  // namespace

ReaderEvent WebSocketReader::next(std::span<const std::uint8_t>& bytes) {
  while (state_ != State::kDone) {
    if (state_ == State::kHeader) {
      if (!fill_header(bytes, 2)) return NeedsMoreBytes{};
      if (auto fault = fault_in_first_two_bytes()) return refuse(std::move(*fault));
      if (!fill_header(bytes, header_size())) return NeedsMoreBytes{};
      if (auto fault = begin_frame()) return refuse(std::move(*fault));
    }
    if (!take_payload(bytes)) return NeedsMoreBytes{};
    if (auto event = end_frame()) return std::move(*event);
  }
  bytes = {};
  return NeedsMoreBytes{};
}

/// True once `size` bytes of the header have arrived.
bool WebSocketReader::fill_header(std::span<const std::uint8_t>& bytes, std::size_t size) {
  if (header_filled_ >= size) return true;
  const std::size_t count = std::min(size - header_filled_, bytes.size());
  std::ranges::copy(bytes.first(count),
                    header_.begin() + static_cast<std::ptrdiff_t>(header_filled_));
  header_filled_ += count;
  bytes = bytes.subspan(count);
  return header_filled_ == size;
}

std::size_t WebSocketReader::header_size() const {
  const std::uint8_t length = header_[1] & kLengthBits;
  const std::size_t length_bytes = length == kLength64 ? 8 : length == kLength16 ? 2 : 0;
  const std::size_t mask_bytes = (header_[1] & kMaskBit) != 0 ? 4 : 0;
  return 2 + length_bytes + mask_bytes;
}

std::optional<Violation> WebSocketReader::fault_in_first_two_bytes() const {
  if ((header_[0] & kReservedBits) != 0) {
    return protocol_error("A reserved bit is set, but no WebSocket extension was agreed on.");
  }
  const auto opcode = static_cast<Opcode>(header_[0] & kOpcodeBits);
  if (!is_known(opcode)) {
    return protocol_error("There is no WebSocket opcode " +
                          std::to_string(header_[0] & kOpcodeBits) + ".");
  }
  const bool masked = (header_[1] & kMaskBit) != 0;
  if (role_ == WebSocketRole::kServer && !masked) {
    return protocol_error("A client must mask its WebSocket frames.");
  }
  if (role_ == WebSocketRole::kClient && masked) {
    return protocol_error("A server must not mask its WebSocket frames.");
  }
  if (is_control(opcode) && (header_[1] & kLengthBits) > kMaxControlPayload) {
    return protocol_error("A WebSocket control frame holds at most 125 bytes.");
  }
  return fault_in_order(opcode, (header_[0] & kFinBit) != 0);
}

std::optional<Violation> WebSocketReader::fault_in_order(Opcode opcode, bool final) const {
  if (is_control(opcode)) {
    if (!final) return protocol_error("A WebSocket control frame must not be fragmented.");
    return std::nullopt;
  }
  if (opcode == Opcode::kText) {
    return Violation{close_code::kUnsupportedData,
                     "Text messages are not accepted; send binary ones."};
  }
  if (opcode == Opcode::kContinuation && !in_message_) {
    return protocol_error("A continuation came without the start of its WebSocket message.");
  }
  if (opcode == Opcode::kBinary && in_message_) {
    return protocol_error("A new WebSocket message began before the end of the last one.");
  }
  return std::nullopt;
}

std::uint64_t WebSocketReader::announced_length() const {
  const std::uint8_t length = header_[1] & kLengthBits;
  if (length < kLength16) return length;
  const std::size_t length_bytes = length == kLength64 ? 8 : 2;
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < length_bytes; ++i) value = value << 8 | header_[2 + i];
  return value;
}

/// Processes the complete header, unless its length is not allowed.
std::optional<Violation> WebSocketReader::begin_frame() {
  const std::uint64_t length = announced_length();
  const std::uint8_t form = header_[1] & kLengthBits;
  if ((form == kLength16 && length < kLength16) || (form == kLength64 && length <= 0xFFFF)) {
    return protocol_error("A WebSocket frame's length is not in its shortest form.");
  }
  if ((length >> 63) != 0) return protocol_error("A WebSocket frame's length has its top bit set.");

  opcode_ = static_cast<Opcode>(header_[0] & kOpcodeBits);
  final_ = (header_[0] & kFinBit) != 0;
  if (!is_control(opcode_)) {
    const std::size_t before = message_.size();
    if (before > max_message_bytes_ || length > max_message_bytes_ - before) {
      return Violation{close_code::kTooLarge, "A message is larger than the limit of " +
                                                  std::to_string(max_message_bytes_) + " bytes."};
    }
    in_message_ = true;
  }
  const auto mask_at = header_.begin() + static_cast<std::ptrdiff_t>(header_size() - 4);
  mask_ = {};
  if (role_ == WebSocketRole::kServer) std::copy_n(mask_at, 4, mask_.begin());
  phase_ = 0;
  missing_ = length;
  state_ = State::kPayload;
  return std::nullopt;
}

/// True once the frame is complete.
bool WebSocketReader::take_payload(std::span<const std::uint8_t>& bytes) {
  const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(missing_, bytes.size()));
  const auto came = bytes.first(count);
  if (is_control(opcode_)) {
    mask_copy(std::span(control_).subspan(phase_, count), came, mask_, phase_);
  } else {
    append_to_message(came);
  }
  bytes = bytes.subspan(count);
  phase_ += count;
  missing_ -= count;
  return missing_ == 0;
}

/// A message's memory at most doubles and never exceeds the announced length, so an announcement
/// alone costs nothing.
void WebSocketReader::append_to_message(std::span<const std::uint8_t> came) {
  auto& storage = message_.appendable();
  const std::size_t needed = storage.size() + came.size();
  if (needed > storage.capacity()) {
    const std::uint64_t announced = storage.size() + missing_;
    storage.reserve(static_cast<std::size_t>(
        std::min<std::uint64_t>(announced, std::max(needed, 2 * storage.capacity()))));
  }
  storage.insert(storage.end(), came.begin(), came.end());
  const auto added = std::span(storage).last(came.size());
  if (role_ == WebSocketRole::kServer) mask_copy(added, added, mask_, phase_);
}

std::optional<ReaderEvent> WebSocketReader::end_frame() {
  state_ = State::kHeader;
  header_filled_ = 0;
  if (!is_control(opcode_)) {
    if (!final_) return std::nullopt;
    in_message_ = false;
    return std::exchange(message_, MessageBuffer());
  }
  std::string payload(control_.begin(), control_.begin() + static_cast<std::ptrdiff_t>(phase_));
  if (opcode_ == Opcode::kPing) return Ping{std::move(payload)};
  if (opcode_ == Opcode::kPong) return Pong{std::move(payload)};
  return end_close(payload);
}

ReaderEvent WebSocketReader::end_close(std::string_view payload) {
  if (payload.size() == 1) return refuse(protocol_error("A close frame has half a close code."));
  state_ = State::kDone;
  if (payload.empty()) return PeerClose{};
  const auto code = static_cast<std::uint16_t>(control_[0] << 8 | control_[1]);
  if (!may_be_sent(code)) {
    return refuse(protocol_error("The close code " + std::to_string(code) + " must not be sent."));
  }
  const std::string_view reason = payload.substr(2);
  if (!is_utf8(reason)) {
    return refuse({close_code::kInvalidText, "The reason in a close frame is not UTF-8."});
  }
  return PeerClose{code, std::string(reason)};
}

ReaderEvent WebSocketReader::refuse(Violation violation) {
  state_ = State::kDone;
  message_ = MessageBuffer();
  return violation;
}

}  // namespace roomcast::net
