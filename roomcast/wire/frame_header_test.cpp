// SPDX-License-Identifier: Apache-2.0
#include "roomcast/wire/frame_header.h"

#include <vector>

#include <gtest/gtest.h>

#include "roomcast/wire/limits.h"

namespace roomcast::wire {
namespace {

FrameHeader some_header() {
  FrameHeader header;
  header.key = true;
  header.last = true;
  header.small = true;
  header.sensor = SensorId{0x1234};
  header.layer = 1;
  header.codec = 1;
  header.seq = 0xAABBCCDD;
  header.base_seq = 0xAABBCCDD;
  header.set = SetId{0x0102030405060708};
  header.capture_time = RoomTime(nanoseconds(-2));
  header.clock_error_us = 350;
  header.payload_length = 3;
  return header;
}

std::vector<std::uint8_t> framed(const FrameHeader& header) {
  std::vector<std::uint8_t> message(kFrameHeaderBytes + header.payload_length, 0x55);
  write_frame_header(header, std::span(message).first<kFrameHeaderBytes>());
  return message;
}

TEST(FrameHeader, decoding_reverses_encoding) {
  const auto parsed = parse_frame(framed(some_header()));
  ASSERT_TRUE(parsed.ok()) << parsed.error().message;
  EXPECT_EQ(*parsed, some_header());
}

TEST(FrameHeader, bytes_lie_where_the_spec_says) {
  const auto message = framed(some_header());
  const std::vector<std::uint8_t> expected = {
      'R',  'C',  1,    1,    48,   0,    7,    0,     // magic, version, type, header length, flags
      0x34, 0x12, 1,    1,    0xDD, 0xCC, 0xBB, 0xAA,  // sensor, layer, codec, seq
      8,    7,    6,    5,    4,    3,    2,    1,     // set
      0xFE, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF,  // capture_ns
      0x5E, 1,    0,    0,    0xDD, 0xCC, 0xBB, 0xAA,  // clock error, base seq
      3,    0,    0,    0,    0,    0,    0,    0,     // payload length, reserved
      0x55, 0x55, 0x55};
  EXPECT_EQ(message, expected);
}

TEST(FrameHeader, a_longer_header_of_a_later_version_is_skipped) {
  auto message = framed(some_header());
  message.insert(message.begin() + kFrameHeaderBytes, 8, 0);
  message[4] = 56;
  const auto parsed = parse_frame(message);
  ASSERT_TRUE(parsed.ok());
  EXPECT_EQ(parsed->header_length, 56);
  EXPECT_EQ(parsed->payload_length, 3u);
}

TEST(FrameHeader, unknown_flags_and_reserved_bytes_are_ignored) {
  auto message = framed(some_header());
  message[7] = 0x80;
  message[44] = 1;
  const auto parsed = parse_frame(message);
  ASSERT_TRUE(parsed.ok());
  EXPECT_EQ(*parsed, some_header());
}

TEST(FrameHeader, every_truncation_is_refused) {
  const auto message = framed(some_header());
  for (std::size_t length = 0; length < message.size(); ++length) {
    EXPECT_FALSE(parse_frame(std::span(message).first(length)).ok()) << length;
  }
}

struct Damage {
  const char* what;
  std::size_t at;
  std::uint8_t value;
  ErrorCode code;
};

class DamagedFrame : public testing::TestWithParam<Damage> {};

TEST_P(DamagedFrame, is_refused_with_a_reason) {
  auto message = framed(some_header());
  message[GetParam().at] = GetParam().value;
  const auto parsed = parse_frame(message);
  ASSERT_FALSE(parsed.ok());
  EXPECT_EQ(parsed.error().code, GetParam().code);
  EXPECT_FALSE(parsed.error().message.empty());
}

INSTANTIATE_TEST_SUITE_P(All, DamagedFrame,
                         testing::Values(Damage{"magic", 0, 'X', ErrorCode::kMalformed},
                                         Damage{"version", 2, 2, ErrorCode::kUnsupported},
                                         Damage{"type", 3, 9, ErrorCode::kUnsupported},
                                         Damage{"control", 3, 2, ErrorCode::kMalformed},
                                         Damage{"short_header", 4, 47, ErrorCode::kMalformed},
                                         Damage{"long_header", 4, 60, ErrorCode::kMalformed},
                                         Damage{"layer", 10, 8, ErrorCode::kMalformed},
                                         Damage{"key_with_a_base", 36, 0, ErrorCode::kMalformed},
                                         Damage{"payload_too_short", 40, 2, ErrorCode::kMalformed},
                                         Damage{"payload_huge", 43, 0xFF, ErrorCode::kMalformed}),
                         [](const auto& test) { return test.param.what; });

TEST(FrameHeader, a_frame_of_the_limit_passes_and_one_byte_more_does_not) {
  auto header = some_header();
  header.payload_length = kMaxFrameBytes - kFrameHeaderBytes;
  EXPECT_TRUE(parse_frame(framed(header)).ok());
  ++header.payload_length;
  const auto parsed = parse_frame(framed(header));
  ASSERT_FALSE(parsed.ok());
  EXPECT_EQ(parsed.error().code, ErrorCode::kTooLarge);
}

TEST(FrameHeader, stamping_changes_the_set_and_the_last_flag_only) {
  auto header = some_header();
  header.last = false;
  auto message = framed(header);
  stamp_frame_set(message, SetId{99}, true);
  header.set = SetId{99};
  header.last = true;
  EXPECT_EQ(message, framed(header));
  stamp_frame_set(message, SetId{100}, false);
  header.set = SetId{100};
  header.last = false;
  EXPECT_EQ(message, framed(header));
}

TEST(FrameHeader, stamping_the_source_changes_sensor_and_time_only) {
  auto header = some_header();
  auto message = framed(header);
  header.sensor = SensorId{4321};
  header.capture_time += std::chrono::seconds(7);
  header.clock_error_us = 815;
  stamp_source(message, header);
  EXPECT_EQ(message, framed(header));
}

}  // namespace
}  // namespace roomcast::wire
