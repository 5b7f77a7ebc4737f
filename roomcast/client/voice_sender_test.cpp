// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/voice_sender.h"

#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/wire/audio_header.h"

namespace roomcast::client {
namespace {

using namespace std::chrono_literals;

constexpr std::array<std::uint8_t, 3> kSpoken{1, 2, 3};

wire::AudioHeader next_header(VoiceSender& sender) {
  const auto message = sender.next();
  EXPECT_NE(message, nullptr);
  if (!message) return {};
  const auto header = wire::parse_audio(message->payload());
  EXPECT_TRUE(header.ok());
  return header ? *header : wire::AudioHeader();
}

TEST(VoiceSender, numbers_packets_and_tells_their_room_time) {
  VoiceSender sender;
  sender.joined();
  sender.clock_is({.at = HostTime(5s), .room_minus_host = 100s});
  sender.say(kSpoken, false, HostTime(5s));
  sender.say(kSpoken, true, HostTime(5s + 20ms));
  const auto first = next_header(sender), last = next_header(sender);
  EXPECT_EQ(first.seq, 0u);
  EXPECT_EQ(first.capture_time, RoomTime(105s));
  EXPECT_EQ(first.payload_length, 3);
  EXPECT_FALSE(first.ends);
  EXPECT_EQ(last.seq, 1u);
  EXPECT_TRUE(last.ends);
  EXPECT_EQ(sender.next(), nullptr);
}

TEST(VoiceSender, drops_what_is_said_without_a_connection_and_begins_anew_with_the_next) {
  VoiceSender sender;
  sender.say(kSpoken, false, HostTime());
  sender.joined();
  sender.say(kSpoken, false, HostTime());
  EXPECT_EQ(sender.next(), nullptr) << "room time is not known yet";
  sender.clock_is({});
  sender.say(kSpoken, false, HostTime());
  sender.lost();
  EXPECT_EQ(sender.next(), nullptr);
  sender.joined();
  sender.clock_is({});
  sender.say(kSpoken, false, HostTime());
  EXPECT_EQ(next_header(sender).seq, 0u);
}

TEST(VoiceSender, drops_the_oldest_packets_when_the_network_does_not_keep_up) {
  VoiceSender sender;
  sender.joined();
  sender.clock_is({});
  for (std::size_t i = 0; i < VoiceSender::kMaxWaiting + 5; ++i)
    sender.say(kSpoken, false, HostTime());
  EXPECT_EQ(next_header(sender).seq, 5u);
}

}  // namespace
}  // namespace roomcast::client
