// SPDX-License-Identifier: Apache-2.0
#include "roomcast/voice/talk_gate.h"

#include <vector>

#include <gtest/gtest.h>

namespace roomcast::voice {
namespace {

/// How many of the blocks are sent.
int sent(TalkGate& gate, float loudness, int blocks, TalkMode mode = TalkMode::kVoice,
         bool is_pushed = false) {
  const std::vector<float> block(kPacketSamples, loudness);
  int count = 0;
  for (int i = 0; i < blocks; ++i) count += gate.is_open(block, mode, is_pushed) ? 1 : 0;
  return count;
}

TEST(TalkGate, is_closed_in_silence_and_opens_at_once_for_a_voice) {
  TalkGate gate;
  EXPECT_EQ(sent(gate, 0.0005F, 100), 0);
  EXPECT_EQ(sent(gate, 0.1F, 1), 1);
}

TEST(TalkGate, stays_open_for_400_ms_so_that_words_are_not_cut_off) {
  TalkGate gate;
  (void)sent(gate, 0.0005F, 10);
  (void)sent(gate, 0.1F, 5);
  EXPECT_EQ(sent(gate, 0.0005F, 50), 19);
}

TEST(TalkGate, learns_the_noise_of_a_loud_room_within_seconds) {
  TalkGate gate;
  EXPECT_GT(sent(gate, 0.02F, 10), 0);
  (void)sent(gate, 0.02F, 320);
  EXPECT_EQ(sent(gate, 0.02F, 50), 0);
  EXPECT_EQ(sent(gate, 0.1F, 5), 5) << "a voice above it";
}

TEST(TalkGate, with_push_to_talk_follows_the_key_alone) {
  TalkGate gate;
  EXPECT_EQ(sent(gate, 0.5F, 5, TalkMode::kPush, false), 0);
  EXPECT_EQ(sent(gate, 0, 5, TalkMode::kPush, true), 5);
}

}  // namespace
}  // namespace roomcast::voice
