// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/voices/voice_listener.h"

#include <chrono>

#include <gtest/gtest.h>

#include "roomcast/voice/voice_encoder.h"

namespace roomcast::client {
namespace {

using namespace std::chrono_literals;

HeardPacket spoken(std::uint32_t seq, unsigned speaker = 1) {
  voice::VoiceEncoder encoder;
  HeardPacket packet;
  packet.speaker = ViewerId{speaker};
  packet.seq = seq;
  packet.capture_time = RoomTime(100s + seq * 20ms);
  packet.opus = encoder.encode(std::array<float, voice::kPacketSamples>{});
  return packet;
}

std::vector<std::uint32_t> seqs_after(VoiceListener& listener, HeardPacket packet) {
  listener.take(std::move(packet));
  std::vector<std::uint32_t> seqs;
  while (const auto heard = listener.next()) {
    seqs.push_back(heard->packet.seq);
    EXPECT_EQ(heard->packet.capture_time, RoomTime(100s + heard->packet.seq * 20ms));
  }
  return seqs;
}

TEST(VoiceListener, up_to_three_lost_packets_are_concealed) {
  VoiceListener listener;
  EXPECT_EQ(seqs_after(listener, spoken(10)), std::vector<std::uint32_t>{10});
  EXPECT_EQ(seqs_after(listener, spoken(11)), std::vector<std::uint32_t>{11});
  EXPECT_EQ(seqs_after(listener, spoken(15)), (std::vector<std::uint32_t>{12, 13, 14, 15}));
  EXPECT_EQ(seqs_after(listener, spoken(20)), std::vector<std::uint32_t>{20});
}

TEST(VoiceListener, a_concealed_packet_has_sound_and_no_opus) {
  VoiceListener listener;
  listener.take(spoken(0));
  listener.take(spoken(2));
  EXPECT_FALSE(listener.next()->packet.opus.empty());
  EXPECT_TRUE(listener.next()->packet.opus.empty());
  EXPECT_FALSE(listener.next()->packet.opus.empty());
}

TEST(VoiceListener, speakers_are_counted_apart_and_the_longest_silent_are_forgotten) {
  VoiceListener listener;
  for (unsigned speaker = 0; speaker < 2 * VoiceListener::kMaxSpeakers; ++speaker)
    EXPECT_EQ(seqs_after(listener, spoken(7, speaker)).size(), 1u);
  EXPECT_EQ(seqs_after(listener, spoken(9, 0)).size(), 1u) << "forgotten";
  EXPECT_EQ(seqs_after(listener, spoken(9, 2 * VoiceListener::kMaxSpeakers - 1)).size(), 2u);
}

TEST(VoiceListener, what_is_no_opus_is_concealed) {
  VoiceListener listener;
  auto broken = spoken(0);
  broken.opus = {0xFF};
  EXPECT_EQ(seqs_after(listener, std::move(broken)).size(), 1u);
}

}  // namespace
}  // namespace roomcast::client
