// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/voices/spoken_voice.h"

#include <gtest/gtest.h>

namespace roomcast::client {
namespace {

using namespace std::chrono_literals;

constexpr HostTime kNow{1000s};

std::vector<float> silence(std::size_t count) {
  return std::vector<float>(count, 0.0F);
}

TEST(SpokenVoice, what_was_just_recorded_goes_out_in_packets_of_20_ms) {
  SpokenVoice voice;
  auto packets = voice.say(silence(1500), kNow);  // 31.25 ms
  ASSERT_TRUE(packets.ok());
  ASSERT_EQ(packets->size(), 1u);
  EXPECT_EQ(packets->front().first_sample, kNow - 31'250us);
  packets = voice.say(silence(480), kNow + 10ms);
  ASSERT_EQ(packets->size(), 1u);
  EXPECT_EQ(packets->front().first_sample, kNow - 11'250us);
  EXPECT_FALSE(packets->front().ends);
  const auto last = voice.pause();
  ASSERT_TRUE(last);
  EXPECT_TRUE(last->ends);
  EXPECT_EQ(last->first_sample, kNow + 8'750us);
  EXPECT_FALSE(voice.pause());
}

TEST(SpokenVoice, calls_that_come_unevenly_leave_no_gaps) {
  SpokenVoice voice;
  HostTime expected = kNow - 20ms;
  for (int i = 0; i < 50; ++i) {
    const auto packets = voice.say(silence(960), kNow + i * 20ms + (i % 3) * 15ms);
    ASSERT_EQ(packets->size(), 1u);
    EXPECT_EQ(packets->front().first_sample, expected);
    expected += 20ms;
  }
}

TEST(SpokenVoice, who_fell_silent_without_a_word_begins_anew) {
  SpokenVoice voice;
  (void)voice.say(silence(970), kNow);
  const auto packets = voice.say(silence(960), kNow + 5s);
  ASSERT_EQ(packets->size(), 1u);
  EXPECT_EQ(packets->front().first_sample, kNow + 5s - 20ms);
}

TEST(SpokenVoice, more_than_real_time_is_refused_also_when_pauses_are_told_between) {
  SpokenVoice voice;
  EXPECT_FALSE(voice.say(silence(48'001), kNow).ok());
  std::size_t said = 0;
  for (int i = 0; i < 10; ++i) {
    const auto packets = voice.say(silence(24'000), kNow);
    if (packets) said += packets->size();
    if (voice.pause()) ++said;
  }
  EXPECT_LE(said, 150u) << "a hub takes so many at once";
  EXPECT_FALSE(voice.say(silence(24'000), kNow).ok());
  EXPECT_TRUE(voice.say(silence(24'000), kNow + 2s).ok());
}

}  // namespace
}  // namespace roomcast::client
