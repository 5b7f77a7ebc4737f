// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/heard_voices.h"

#include <thread>

#include <gtest/gtest.h>

namespace roomcast::client {
namespace {

using namespace std::chrono_literals;

HeardPacket packet_of(std::uint32_t seq) {
  HeardPacket packet;
  packet.seq = seq;
  return packet;
}

TEST(HeardVoices, gives_packets_in_the_order_in_which_they_came) {
  HeardVoices voices;
  EXPECT_FALSE(voices.next(0ms));
  voices.push(packet_of(1));
  voices.push(packet_of(2));
  EXPECT_EQ(voices.next(0ms)->seq, 1u);
  EXPECT_EQ(voices.next(10s)->seq, 2u);
}

TEST(HeardVoices, drops_the_oldest_for_a_program_that_does_not_listen) {
  HeardVoices voices;
  for (std::uint32_t i = 0; i < HeardVoices::kMaxWaiting + 3; ++i) voices.push(packet_of(i));
  EXPECT_EQ(voices.next(0ms)->seq, 3u);
}

TEST(HeardVoices, an_end_wakes_who_waits) {
  HeardVoices voices;
  const std::jthread waits([&] { EXPECT_FALSE(voices.next(60s)); });
  voices.end();
}

}  // namespace
}  // namespace roomcast::client
