// SPDX-License-Identifier: Apache-2.0
#include "roomcast/wire/audio_header.h"

#include <vector>

#include <gtest/gtest.h>

#include "roomcast/wire/limits.h"

namespace roomcast::wire {
namespace {

AudioHeader some_audio_header() {
  AudioHeader header;
  header.ends = true;
  header.speaker = ViewerId{0x12345678};
  header.seq = 0xAABBCCDD;
  header.capture_time = RoomTime(nanoseconds(-2));
  header.payload_length = 3;
  return header;
}

std::vector<std::uint8_t> audio_message(const AudioHeader& header) {
  std::vector<std::uint8_t> message(kAudioHeaderBytes + header.payload_length, 0x55);
  write_audio_header(header, std::span(message).first<kAudioHeaderBytes>());
  return message;
}

TEST(AudioHeader, decoding_reverses_encoding) {
  const auto parsed = parse_audio(audio_message(some_audio_header()));
  ASSERT_TRUE(parsed.ok()) << parsed.error().message;
  EXPECT_EQ(*parsed, some_audio_header());
}

TEST(AudioHeader, bytes_lie_where_the_spec_says) {
  const std::vector<std::uint8_t> expected = {
      'R',  'C',  1,    3,    28,   0,    1,    0,     // magic, version, type, header length, flags
      0x78, 0x56, 0x34, 0x12, 0xDD, 0xCC, 0xBB, 0xAA,  // speaker, seq
      0xFE, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF,  // capture_ns
      3,    0,    1,    0,                             // payload length, codec, reserved
      0x55, 0x55, 0x55};
  EXPECT_EQ(audio_message(some_audio_header()), expected);
}

TEST(AudioHeader, a_longer_header_of_a_later_version_is_skipped) {
  auto message = audio_message(some_audio_header());
  message.insert(message.begin() + kAudioHeaderBytes, 8, 0);
  message[4] = 36;
  const auto parsed = parse_audio(message);
  ASSERT_TRUE(parsed.ok());
  EXPECT_EQ(parsed->header_length, 36);
  EXPECT_EQ(parsed->payload_length, 3);
}

TEST(AudioHeader, unknown_flags_and_reserved_bytes_are_ignored) {
  auto message = audio_message(some_audio_header());
  message[7] = 0x80;
  message[27] = 1;
  const auto parsed = parse_audio(message);
  ASSERT_TRUE(parsed.ok());
  EXPECT_EQ(*parsed, some_audio_header());
}

TEST(AudioHeader, every_truncation_is_refused) {
  const auto message = audio_message(some_audio_header());
  for (std::size_t length = 0; length < message.size(); ++length) {
    EXPECT_FALSE(parse_audio(std::span(message).first(length)).ok()) << length;
  }
}

TEST(AudioHeader, a_frame_is_no_audio_packet) {
  auto message = audio_message(some_audio_header());
  message[3] = 1;
  const auto parsed = parse_audio(message);
  ASSERT_FALSE(parsed.ok());
  EXPECT_EQ(parsed.error().code, ErrorCode::kMalformed);
}

TEST(AudioHeader, a_header_that_is_too_short_or_too_long_is_refused) {
  for (const std::uint8_t length : {27, 29, 255}) {
    auto message = audio_message(some_audio_header());
    message[4] = length;
    EXPECT_FALSE(parse_audio(message).ok()) << int{length};
  }
}

TEST(AudioHeader, a_packet_without_payload_is_refused) {
  auto header = some_audio_header();
  header.payload_length = 0;
  EXPECT_FALSE(parse_audio(audio_message(header)).ok());
}

TEST(AudioHeader, a_payload_of_the_limit_passes_and_one_byte_more_does_not) {
  auto header = some_audio_header();
  header.payload_length = kMaxAudioPayloadBytes;
  EXPECT_TRUE(parse_audio(audio_message(header)).ok());
  ++header.payload_length;
  const auto parsed = parse_audio(audio_message(header));
  ASSERT_FALSE(parsed.ok());
  EXPECT_EQ(parsed.error().code, ErrorCode::kTooLarge);
}

TEST(AudioHeader, a_message_over_the_limit_is_refused_whatever_its_header_says) {
  auto message = audio_message(some_audio_header());
  message.resize(kMaxAudioBytes + 1);
  const auto parsed = parse_audio(message);
  ASSERT_FALSE(parsed.ok());
  EXPECT_EQ(parsed.error().code, ErrorCode::kTooLarge);
}

TEST(AudioHeader, stamping_changes_the_speaker_only) {
  auto header = some_audio_header();
  auto message = audio_message(header);
  stamp_speaker(message, ViewerId{7});
  header.speaker = ViewerId{7};
  EXPECT_EQ(message, audio_message(header));
}

TEST(AudioHeader, sensors_have_speakers_of_their_own) {
  EXPECT_EQ(speaker_of(SensorId{5}).value, 0x8000'0005U);
  EXPECT_EQ(sensor_of(speaker_of(SensorId{5})), SensorId{5});
  EXPECT_EQ(sensor_of(speaker_of(SensorId{0xFFFF})), SensorId{0xFFFF});
  for (const std::uint32_t viewer : {0U, 5U, 0x7FFF'FFFFU, 0x8001'0000U, 0xFFFF'FFFFU})
    EXPECT_FALSE(sensor_of(ViewerId{viewer})) << viewer;
}

}  // namespace
}  // namespace roomcast::wire
