// SPDX-License-Identifier: Apache-2.0
#include "roomcast/wire/frame_header.h"

#include <string>

#include "roomcast/core/assert.h"
#include "roomcast/core/little_endian.h"
#include "roomcast/wire/limits.h"

namespace roomcast::wire {
namespace {

// Offsets of docs/spec/wire.md §2.
constexpr std::size_t kHeaderLengthAt = 4, kFlagsAt = 6, kSensorAt = 8, kLayerAt = 10,
                      kCodecAt = 11, kSeqAt = 12, kSetAt = 16, kCaptureAt = 24, kClockErrorAt = 32,
                      kBaseSeqAt = 36, kPayloadLengthAt = 40, kReservedAt = 44;
constexpr std::uint16_t kFlagKey = 1, kFlagLast = 2, kFlagSmall = 4;

FrameHeader load_header(std::span<const std::uint8_t> message) {
  const auto flags = read_u16(&message[kFlagsAt]);
  FrameHeader header;
  header.key = (flags & kFlagKey) != 0;
  header.last = (flags & kFlagLast) != 0;
  header.small = (flags & kFlagSmall) != 0;
  header.sensor = SensorId{read_u16(&message[kSensorAt])};
  header.layer = message[kLayerAt];
  header.codec = message[kCodecAt];
  header.seq = read_u32(&message[kSeqAt]);
  header.set = SetId{read_u64(&message[kSetAt])};
  header.capture_time =
      RoomTime(nanoseconds(static_cast<std::int64_t>(read_u64(&message[kCaptureAt]))));
  header.clock_error_us = read_u32(&message[kClockErrorAt]);
  header.base_seq = read_u32(&message[kBaseSeqAt]);
  header.payload_length = read_u32(&message[kPayloadLengthAt]);
  header.header_length = read_u16(&message[kHeaderLengthAt]);
  return header;
}

Status check_header(const FrameHeader& header, std::size_t message_bytes) {
  const auto malformed = [](std::string what) {
    return Error{ErrorCode::kMalformed, std::move(what)};
  };
  if (header.header_length < kFrameHeaderBytes)
    return malformed("a frame header is at least 48 bytes long");
  if (std::size_t{header.header_length} + header.payload_length != message_bytes) {
    return malformed("a frame's header and payload lengths do not add up to its message's length");
  }
  if (header.layer > kMaxLayer) return malformed("a frame's temporal layer is at most 7");
  if (header.key && header.base_seq != header.seq) {
    return malformed("a key frame needs no other frame: its base_seq equals its seq");
  }
  return {};
}

}  // namespace

Result<MessageType> message_type(std::span<const std::uint8_t> message) {
  if (message.size() < kPreambleBytes || read_u16(&message[0]) != kMagic) {
    return Error{ErrorCode::kMalformed, "this is not a roomcast message"};
  }
  if (message[2] != kVersion) {
    return Error{ErrorCode::kUnsupported, "roomcast version " + std::to_string(message[2]) +
                                              " is not supported, only version 1"};
  }
  const auto type = static_cast<MessageType>(message[3]);
  if (type != MessageType::kFrame && type != MessageType::kControl && type != MessageType::kAudio) {
    return Error{ErrorCode::kUnsupported,
                 "message type " + std::to_string(message[3]) + " is unknown"};
  }
  return type;
}

Result<FrameHeader> parse_frame(std::span<const std::uint8_t> message) {
  const auto type = message_type(message);
  if (!type) return type.error();
  if (*type != MessageType::kFrame)
    return Error{ErrorCode::kMalformed, "this message is not a frame"};
  if (message.size() > kMaxFrameBytes) {
    return Error{ErrorCode::kTooLarge, "a frame is at most 2 MiB, header included"};
  }
  if (message.size() < kFrameHeaderBytes) {
    return Error{ErrorCode::kMalformed, "a frame message ends inside its header"};
  }
  const FrameHeader header = load_header(message);
  if (auto status = check_header(header, message.size()); !status) return status.error();
  return header;
}

void write_preamble(MessageType type, std::span<std::uint8_t, kPreambleBytes> out) {
  write_u16(&out[0], kMagic);
  out[2] = kVersion;
  out[3] = static_cast<std::uint8_t>(type);
}

void write_frame_header(const FrameHeader& header, std::span<std::uint8_t, kFrameHeaderBytes> out) {
  write_preamble(MessageType::kFrame, out.first<kPreambleBytes>());
  write_u16(&out[kHeaderLengthAt], static_cast<std::uint16_t>(kFrameHeaderBytes));
  write_u16(&out[kFlagsAt],
            static_cast<std::uint16_t>((header.key ? kFlagKey : 0) | (header.last ? kFlagLast : 0) |
                                       (header.small ? kFlagSmall : 0)));
  out[kLayerAt] = header.layer;
  out[kCodecAt] = header.codec;
  write_u32(&out[kSeqAt], header.seq);
  write_u64(&out[kSetAt], header.set.value);
  write_u32(&out[kBaseSeqAt], header.base_seq);
  write_u32(&out[kPayloadLengthAt], header.payload_length);
  write_u32(&out[kReservedAt], 0);
  stamp_source(out, header);
}

void stamp_frame_set(std::span<std::uint8_t> message, SetId set, bool last) {
  ROOMCAST_ASSERT(message.size() >= kFrameHeaderBytes);
  const auto flags = read_u16(&message[kFlagsAt]);
  write_u16(&message[kFlagsAt],
            static_cast<std::uint16_t>(last ? flags | kFlagLast : flags & ~kFlagLast));
  write_u64(&message[kSetAt], set.value);
}

void stamp_source(std::span<std::uint8_t> message, const FrameHeader& header) {
  ROOMCAST_ASSERT(message.size() >= kFrameHeaderBytes);
  write_u16(&message[kSensorAt], header.sensor.value);
  write_u64(&message[kCaptureAt],
            static_cast<std::uint64_t>(header.capture_time.time_since_epoch().count()));
  write_u32(&message[kClockErrorAt], header.clock_error_us);
}

}  // namespace roomcast::wire
