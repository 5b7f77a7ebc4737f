// SPDX-License-Identifier: Apache-2.0
// Parts of a WebSocket frame: opcodes, close codes, header and masking. Pure functions on bytes.
// Source: RFC 6455 sections 5.2 (framing), 5.3 (masking), 7.4 (close codes).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace roomcast::net {

/// Our role in a connection. A client masks its frames, a server does not.
enum class WebSocketRole { kServer, kClient };

enum class Opcode : std::uint8_t {
  kContinuation = 0x0,
  kText = 0x1,
  kBinary = 0x2,
  kClose = 0x8,
  kPing = 0x9,
  kPong = 0xA,
};

/// First byte: the message ends with this frame. Second byte: the payload is masked.
inline constexpr std::uint8_t kFinBit = 0x80, kMaskBit = 0x80;

/// Close, ping or pong.
[[nodiscard]] constexpr bool is_control(Opcode opcode) {
  return static_cast<std::uint8_t>(opcode) >= 0x8;
}

namespace close_code {
inline constexpr std::uint16_t kNormal = 1000;
inline constexpr std::uint16_t kGoingAway = 1001;
inline constexpr std::uint16_t kProtocolError = 1002;
inline constexpr std::uint16_t kUnsupportedData = 1003;
inline constexpr std::uint16_t kNoCode = 1005;  // never sent: the peer's close frame had no code
inline constexpr std::uint16_t kAbnormal =
    1006;  // never sent: the connection broke without a close frame
inline constexpr std::uint16_t kInvalidText = 1007;
inline constexpr std::uint16_t kPolicy = 1008;
inline constexpr std::uint16_t kTooLarge = 1009;
inline constexpr std::uint16_t kTryAgainLater = 1013;
}  // namespace close_code

/// Whether a close frame may contain this code (RFC 6455 section 7.4 and the IANA registry).
[[nodiscard]] bool may_be_sent(std::uint16_t close_code);

/// Maximum payload of a ping, pong or close frame.
inline constexpr std::size_t kMaxControlPayload = 125;
/// Maximum reason of a close frame: the payload after the code.
inline constexpr std::size_t kMaxCloseReason = kMaxControlPayload - 2;
inline constexpr std::size_t kMaxFrameHeader = 14;

using MaskKey = std::array<std::uint8_t, 4>;

/// Header of a whole message or control frame (FIN set; we never send fragments).
struct FrameHeader {
  std::array<std::uint8_t, kMaxFrameHeader> bytes{};
  std::size_t size = 0;
  [[nodiscard]] std::span<const std::uint8_t> view() const { return std::span(bytes).first(size); }
};
[[nodiscard]] FrameHeader make_frame_header(Opcode opcode, std::uint64_t payload_size,
                                            std::optional<MaskKey> mask = std::nullopt);

/// `to[i] = from[i] ^ key[(phase + i) % 4]`; the same in both directions. `to` and `from` have
/// equal length and are the same memory or do not overlap. `phase`: number of preceding bytes of
/// the frame's payload.
void mask_copy(std::span<std::uint8_t> to, std::span<const std::uint8_t> from, MaskKey key,
               std::size_t phase);

/// The reason cut to kMaxCloseReason bytes at a character boundary.
[[nodiscard]] std::string_view cut_close_reason(std::string_view reason);

}  // namespace roomcast::net
