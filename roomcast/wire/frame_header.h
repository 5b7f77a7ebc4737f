// SPDX-License-Identifier: Apache-2.0
// The fixed part of every message: docs/spec/wire.md §1 and §2. Converts little-endian bytes to
// plain structs and back. Nothing here allocates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "roomcast/core/clock.h"
#include "roomcast/core/ids.h"
#include "roomcast/core/result.h"

namespace roomcast::wire {

inline constexpr std::uint16_t kMagic = 0x4352;  // "RC"
inline constexpr std::uint8_t kVersion = 1;
inline constexpr std::size_t kPreambleBytes = 4;  // magic, version, type
inline constexpr std::size_t kFrameHeaderBytes = 48;
inline constexpr std::uint32_t kClockErrorUnknown = 0xFFFFFFFF;

enum class MessageType : std::uint8_t { kFrame = 1, kControl = 2, kAudio = 3 };

/// The type of a message, from its first four bytes. kMalformed: not a roomcast message.
/// kUnsupported: another version or type.
[[nodiscard]] Result<MessageType> message_type(std::span<const std::uint8_t> message);

struct FrameHeader {
  bool key = false;    // decodable without other frames
  bool last = false;   // the last frame of its frame set; written by the hub
  bool small = false;  // of the sensor's small rendition, which is numbered by itself
  SensorId sensor{};
  std::uint8_t layer = 0;  // temporal layer; later frames depend on layer 0
  std::uint8_t codec = 1;
  std::uint32_t seq = 0;  // counts the rendition's frames since the sensor joined, modulo 2^32
  SetId set{};            // written by the hub
  RoomTime capture_time{};
  std::uint32_t clock_error_us = kClockErrorUnknown;
  std::uint32_t base_seq = 0;  // layer-0 frame that this one needs; own seq for a key frame
  std::uint32_t payload_length = 0;
  std::uint16_t header_length = kFrameHeaderBytes;  // may be longer in a later version

  friend bool operator==(const FrameHeader&, const FrameHeader&) = default;
};

/// Checks a whole frame message (header and payload) against the spec, before any allocation for
/// it. kMalformed, kTooLarge or kUnsupported, with a sentence for the sender.
[[nodiscard]] Result<FrameHeader> parse_frame(std::span<const std::uint8_t> message);

/// `header.header_length` is written as kFrameHeaderBytes.
void write_frame_header(const FrameHeader& header, std::span<std::uint8_t, kFrameHeaderBytes> out);

/// Writes the fields that only the hub knows into a message accepted by `parse_frame`.
void stamp_frame_set(std::span<std::uint8_t> message, SetId set, bool last);

/// Writes the sensor ID, capture time and clock error of `header` into a message accepted by
/// `parse_frame`. A hub that relays another hub's room replaces them by its own.
void stamp_source(std::span<std::uint8_t> message, const FrameHeader& header);

/// Magic, version and type.
void write_preamble(MessageType type, std::span<std::uint8_t, kPreambleBytes> out);

}  // namespace roomcast::wire
