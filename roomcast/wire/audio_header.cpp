// SPDX-License-Identifier: Apache-2.0
#include "roomcast/wire/audio_header.h"

#include <string>

#include "roomcast/core/assert.h"
#include "roomcast/core/little_endian.h"
#include "roomcast/wire/frame_header.h"
#include "roomcast/wire/limits.h"

namespace roomcast::wire {
namespace {

// Offsets of docs/spec/wire.md §6.
constexpr std::size_t kAudioHeaderLengthAt = 4, kAudioFlagsAt = 6, kSpeakerAt = 8, kAudioSeqAt = 12,
                      kAudioCaptureAt = 16, kAudioPayloadLengthAt = 24, kAudioCodecAt = 26,
                      kAudioReservedAt = 27;
constexpr std::uint16_t kFlagEnds = 1;

AudioHeader load_audio_header(std::span<const std::uint8_t> message) {
  AudioHeader header;
  header.ends = (read_u16(&message[kAudioFlagsAt]) & kFlagEnds) != 0;
  header.speaker = ViewerId{read_u32(&message[kSpeakerAt])};
  header.seq = read_u32(&message[kAudioSeqAt]);
  header.capture_time =
      RoomTime(nanoseconds(static_cast<std::int64_t>(read_u64(&message[kAudioCaptureAt]))));
  header.payload_length = read_u16(&message[kAudioPayloadLengthAt]);
  header.codec = message[kAudioCodecAt];
  header.header_length = read_u16(&message[kAudioHeaderLengthAt]);
  return header;
}

Error malformed_audio(std::string sentence) {
  return {ErrorCode::kMalformed, std::move(sentence)};
}

Status check_audio_header(const AudioHeader& header, std::size_t message_bytes) {
  if (header.header_length < kAudioHeaderBytes)
    return malformed_audio("the header of an audio packet is at least 28 bytes long");
  if (std::size_t{header.header_length} + header.payload_length != message_bytes) {
    return malformed_audio(
        "an audio packet's header and payload lengths do not add up to its message's length");
  }
  if (header.payload_length > kMaxAudioPayloadBytes) {
    return Error{ErrorCode::kTooLarge, "the payload of an audio packet is at most " +
                                           std::to_string(kMaxAudioPayloadBytes) + " bytes"};
  }
  if (header.payload_length == 0) return malformed_audio("an audio packet needs a payload");
  return {};
}

}  // namespace

Result<AudioHeader> parse_audio(std::span<const std::uint8_t> message) {
  const auto type = message_type(message);
  if (!type) return type.error();
  if (*type != MessageType::kAudio) return malformed_audio("this message is not an audio packet");
  if (message.size() > kMaxAudioBytes) {
    return Error{
        ErrorCode::kTooLarge,
        "an audio packet is at most " + std::to_string(kMaxAudioBytes) + " bytes, header included"};
  }
  if (message.size() < kAudioHeaderBytes)
    return malformed_audio("an audio packet ends inside its header");
  const AudioHeader header = load_audio_header(message);
  if (auto status = check_audio_header(header, message.size()); !status) return status.error();
  return header;
}

void write_audio_header(const AudioHeader& header, std::span<std::uint8_t, kAudioHeaderBytes> out) {
  write_preamble(MessageType::kAudio, out.first<kPreambleBytes>());
  write_u16(&out[kAudioHeaderLengthAt], static_cast<std::uint16_t>(kAudioHeaderBytes));
  write_u16(&out[kAudioFlagsAt], header.ends ? kFlagEnds : std::uint16_t{0});
  write_u32(&out[kSpeakerAt], header.speaker.value);
  write_u32(&out[kAudioSeqAt], header.seq);
  write_u64(&out[kAudioCaptureAt],
            static_cast<std::uint64_t>(header.capture_time.time_since_epoch().count()));
  write_u16(&out[kAudioPayloadLengthAt], header.payload_length);
  out[kAudioCodecAt] = header.codec;
  out[kAudioReservedAt] = 0;
}

void stamp_speaker(std::span<std::uint8_t> message, ViewerId speaker) {
  ROOMCAST_ASSERT(message.size() >= kAudioHeaderBytes);
  write_u32(&message[kSpeakerAt], speaker.value);
}

}  // namespace roomcast::wire
