// SPDX-License-Identifier: Apache-2.0
// The fixed part of an audio packet, 20 ms of a person's voice or of a room's sound:
// docs/spec/wire.md §6. Converts little-endian bytes to a plain struct and back. Nothing here
// allocates or looks into the payload.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "roomcast/core/clock.h"
#include "roomcast/core/ids.h"
#include "roomcast/core/result.h"

namespace roomcast::wire {

inline constexpr std::size_t kAudioHeaderBytes = 28;
inline constexpr std::uint8_t kAudioCodecOpus = 1;  // RFC 6716; 20 ms, one channel

/// The sound of a sensor's microphone has a speaker, too. Viewers' IDs never grow so large.
inline constexpr std::uint32_t kSensorSpeakers = 0x8000'0000;
[[nodiscard]] constexpr ViewerId speaker_of(SensorId sensor) {
  return ViewerId{kSensorSpeakers + sensor.value};
}
/// Nothing: a viewer speaks.
[[nodiscard]] constexpr std::optional<SensorId> sensor_of(ViewerId speaker) {
  if (speaker.value < kSensorSpeakers || speaker.value > kSensorSpeakers + 0xFFFF) return {};
  return SensorId{static_cast<std::uint16_t>(speaker.value - kSensorSpeakers)};
}

struct AudioHeader {
  bool ends = false;        // the speaker pauses after this packet
  ViewerId speaker{};       // written by the hub; 0 from the speaker
  std::uint32_t seq = 0;    // counts the speaker's packets since it joined, modulo 2^32
  RoomTime capture_time{};  // of the first sample
  std::uint16_t payload_length = 0;
  std::uint8_t codec = kAudioCodecOpus;
  std::uint16_t header_length = kAudioHeaderBytes;  // may be longer in a later version

  friend bool operator==(const AudioHeader&, const AudioHeader&) = default;
};

/// Checks a whole audio packet (header and payload) against the spec. kMalformed, kTooLarge or
/// kUnsupported, with a sentence for the sender.
[[nodiscard]] Result<AudioHeader> parse_audio(std::span<const std::uint8_t> message);

/// `header.header_length` is written as kAudioHeaderBytes.
void write_audio_header(const AudioHeader& header, std::span<std::uint8_t, kAudioHeaderBytes> out);

/// Writes the speaker, which only the hub knows, into a message accepted by `parse_audio`.
void stamp_speaker(std::span<std::uint8_t> message, ViewerId speaker);

}  // namespace roomcast::wire
