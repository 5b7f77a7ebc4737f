// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/voices/voice_track.h"

#include <vector>

#include "roomcast/recording/voices/voice_fixture.h"

namespace roomcast::recording {
namespace {

using namespace std::chrono_literals;

class VoiceTrackTest : public testing::Test {
 protected:
  void take(std::uint32_t seq, nanoseconds time, bool ends = false) {
    take(voice.next_packet(), seq, time, ends);
  }
  void take(const std::vector<std::uint8_t>& opus, std::uint32_t seq, nanoseconds time,
            bool ends = false) {
    track.take({.seq = seq, .ends = ends, .time = time, .opus = opus},
               [this](std::int64_t at, std::span<const float> samples) {
                 places.push_back(at + voice::kEncoderDelaySamples);
                 EXPECT_EQ(samples.size(), voice::kPacketSamples);
                 last.assign(samples.begin(), samples.end());
               });
  }
  VoiceFixture voice{VoiceFixture::tone(0.5F)};
  VoiceTrack track;
  std::vector<std::int64_t> places;
  std::vector<float> last;
};

TEST_F(VoiceTrackTest, packets_follow_each_other_although_their_times_vary) {
  take(7, 1s);
  take(8, 1s + 20ms + 3ms);
  take(9, 1s + 40ms - 4ms);
  EXPECT_EQ(places, (std::vector<std::int64_t>{48'000, 48'960, 49'920}));
}

TEST_F(VoiceTrackTest, after_a_pause_they_are_at_their_own_time) {
  take(0, 1s, true);
  take(1, 1500ms);
  take(2, 1540ms);  // the clock was set by 20 ms
  EXPECT_EQ(places, (std::vector<std::int64_t>{48'000, 72'000, 73'920}));
}

TEST_F(VoiceTrackTest, lost_packets_are_concealed_up_to_60_ms) {
  take(0, 1s);
  (void)voice.next_packet();
  (void)voice.next_packet();
  take(3, 1060ms);
  EXPECT_EQ(places, (std::vector<std::int64_t>{48'000, 48'960, 49'920, 50'880}));
  EXPECT_EQ(track.figures().concealed, 2u);
  EXPECT_EQ(track.figures().packets, 2u);
  take(8, 1160ms);
  EXPECT_EQ(places.back(), 55'680);
  EXPECT_EQ(places.size(), 5u) << "a longer gap stays";
}

TEST_F(VoiceTrackTest, what_came_twice_or_too_late_is_left_out) {
  take(5, 1s);
  take(6, 1020ms);
  take(6, 1020ms);
  take(4, 980ms);
  EXPECT_EQ(places.size(), 2u);
}

TEST_F(VoiceTrackTest, numbers_that_begin_again_are_a_new_beginning) {
  take(5000, 1s);
  take(0, 3s);
  EXPECT_EQ(places, (std::vector<std::int64_t>{48'000, 144'000}));
}

TEST_F(VoiceTrackTest, a_broken_packet_is_concealed) {
  take(0, 1s);
  take(std::vector<std::uint8_t>{0xFB, 0x3F, 1, 2}, 1, 1020ms);
  take(std::vector<std::uint8_t>{}, 2, 1040ms);
  EXPECT_EQ(places.size(), 3u);
  EXPECT_EQ(track.figures().concealed, 2u);
}

TEST_F(VoiceTrackTest, decodes_what_was_said) {
  for (std::uint32_t seq = 0; seq < 20; ++seq) take(seq, 20ms * seq);
  float loudest = 0;
  for (const float sample : last) loudest = std::max(loudest, std::abs(sample));
  EXPECT_NEAR(loudest, 0.5, 0.1);
}

}  // namespace
}  // namespace roomcast::recording
