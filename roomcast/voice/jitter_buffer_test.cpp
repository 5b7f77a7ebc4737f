// SPDX-License-Identifier: Apache-2.0
#include "roomcast/voice/jitter_buffer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "roomcast/voice/talk_gate.h"
#include "roomcast/voice/voice_encoder.h"

namespace roomcast::voice {
namespace {

using namespace std::chrono_literals;

constexpr nanoseconds kPacket = 20ms;

/// A speaker whose packets arrive when the test says so, and a listener that pulls every 20 ms.
class JitterBufferTest : public testing::Test {
 protected:
  SpokenBlock packet(std::uint32_t n, bool ends = false) {
    std::array<float, kPacketSamples> tone{};
    for (std::size_t i = 0; i < tone.size(); ++i)
      tone[i] = 0.3F * static_cast<float>(std::sin(2 * std::numbers::pi * 400 *
                                                   static_cast<double>(i) / kVoiceRate_hz));
    return {.seq = n, .ends = ends, .capture = n * kPacket, .opus = encoder.encode(tone)};
  }
  /// Packet n is captured at n * 20 ms; `way_of` gives its way; none: it is lost.
  template <class WayOf>
  int gaps(int packets, WayOf way_of, std::uint32_t first = 0) {
    std::multimap<nanoseconds, std::uint32_t> arrivals;
    for (int n = 0; n < packets; ++n)
      if (const std::optional<nanoseconds> way = way_of(n))
        arrivals.emplace(n * kPacket + *way, static_cast<std::uint32_t>(n));
    int silent = 0, gap = 0;
    longest_gap = 0;
    bool has_begun = false;
    for (nanoseconds now{}; now < packets * kPacket; now += kPacket) {
      while (!arrivals.empty() && arrivals.begin()->first <= now) {
        const std::uint32_t n = arrivals.begin()->second;
        SpokenBlock block = packet(n);
        block.seq += first;
        buffer.push(std::move(block), arrivals.begin()->first);
        arrivals.erase(arrivals.begin());
      }
      const auto heard = buffer.pull(now);
      has_begun |= heard.has_value();
      gap = has_begun && !heard ? gap + 1 : 0;
      longest_gap = std::max(longest_gap, gap);
      if (gap > 0) ++silent;
    }
    EXPECT_TRUE(has_begun);
    return silent;
  }

  VoiceEncoder encoder;
  JitterBuffer buffer;
  int longest_gap = 0;  // blocks
};

TEST_F(JitterBufferTest, an_even_line_has_no_gaps_and_a_short_delay) {
  EXPECT_EQ(gaps(300, [](int) { return std::optional<nanoseconds>(5ms); }), 0);
  EXPECT_EQ(buffer.figures().concealed, 0u);
  EXPECT_LE(buffer.target_ms(), 40);
}

TEST_F(JitterBufferTest, eight_speakers_on_an_uneven_and_lossy_line_have_no_gaps_above_60_ms) {
  for (unsigned speaker = 1; speaker <= 8; ++speaker) {
    buffer = JitterBuffer();
    std::mt19937 random(speaker);
    std::uniform_int_distribution<int> jitter_ms(0, 50), percent(0, 99);
    const int silent = gaps(1500, [&](int) -> std::optional<nanoseconds> {
      if (percent(random) < 2) return std::nullopt;
      return std::chrono::milliseconds(10 + jitter_ms(random));
    });
    EXPECT_LE(longest_gap, 3) << "blocks of 20 ms";
    EXPECT_LE(silent, 5) << "of 1500 blocks";
    EXPECT_GT(buffer.figures().played, 1400u);
    EXPECT_LT(buffer.target_ms(), 80);
  }
}

TEST_F(JitterBufferTest, numbers_may_begin_again_at_0) {
  EXPECT_EQ(gaps(
                200, [](int) { return std::optional<nanoseconds>(5ms); }, 0xFFFF'FFC0U),
            0);
  EXPECT_EQ(buffer.figures().concealed, 0u);
}

TEST_F(JitterBufferTest, a_pause_is_silence_and_a_speaker_who_joins_again_is_heard) {
  buffer.push(packet(100, true), 2010ms);
  EXPECT_FALSE(buffer.pull(2010ms)) << "it waits for its target";
  EXPECT_TRUE(buffer.pull(2060ms));
  EXPECT_FALSE(buffer.pull(2080ms)) << "nothing is concealed in a pause";
  SpokenBlock again = packet(0);
  again.capture = 5s;
  buffer.push(again, 5010ms);
  EXPECT_TRUE(buffer.pull(5060ms));
}

TEST_F(JitterBufferTest, a_stall_of_the_line_is_caught_up_with) {
  EXPECT_EQ(gaps(100, [](int) { return std::optional<nanoseconds>(5ms); }), 0);
  for (std::uint32_t n = 100; n < 140; ++n) buffer.push(packet(n), 2800ms);
  std::size_t heard = 0;
  for (nanoseconds now = 2800ms; now < 4s; now += kPacket) heard += buffer.pull(now) ? 1 : 0;
  EXPECT_LT(heard, 25u) << "the oldest are left out";
  EXPECT_GT(buffer.figures().skipped, 10u);
}

TEST_F(JitterBufferTest, lost_packets_are_concealed_with_sound) {
  for (std::uint32_t n = 0; n < 10; ++n)
    if (n != 5) buffer.push(packet(n), n * kPacket);
  for (nanoseconds now = 40ms; now < 240ms; now += kPacket) {
    const auto heard = buffer.pull(now);
    ASSERT_TRUE(heard) << now.count();
    EXPECT_GT(loudness_of(*heard), now > 60ms ? 0.02 : -1);
  }
  EXPECT_EQ(buffer.figures().concealed, 1u);
}

TEST_F(JitterBufferTest, bytes_that_are_no_opus_do_no_harm) {
  SpokenBlock broken = packet(0);
  broken.opus = {0xFF, 1, 2};
  buffer.push(broken, 0ms);
  EXPECT_TRUE(buffer.pull(100ms));
}

}  // namespace
}  // namespace roomcast::voice
