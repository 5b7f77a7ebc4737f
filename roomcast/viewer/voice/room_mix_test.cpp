// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/voice/room_mix.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "roomcast/voice/voice_encoder.h"

namespace roomcast::viewer {
namespace {

using namespace std::chrono_literals;

constexpr ViewerId kAda{3}, kBob{4};

class RoomMixTest : public testing::Test {
 protected:
  RoomMixTest() {
    add(kAda, -1);
    add(kBob, 3);
  }
  /// A person at this x, who looks ahead, as the listener does at 0.
  void add(ViewerId id, double x) {
    auto& person = room.people.emplace_back();
    person.id = id;
    person.pose.emplace().world_from_head.translation_m = {x, 0, 0};
  }
  /// 20 ms of a tone at each call, as packet n.
  void say(ViewerId speaker, std::uint32_t n) {
    std::array<float, voice::kPacketSamples> tone{};
    for (std::size_t i = 0; i < tone.size(); ++i)
      tone[i] = 0.2F * static_cast<float>(std::sin(2 * std::numbers::pi * 400 *
                                                   static_cast<double>(i) / voice::kVoiceRate_hz));
    mix.take({.speaker = speaker,
              .seq = n,
              .ends = false,
              .capture_time = RoomTime(n * 20ms),
              .opus = encoder.encode(tone)},
             begin + n * 20ms);
  }
  /// Root of the mean square of the left and the right channel over half a second.
  std::array<double, 2> heard(const std::map<ViewerId, float>& volumes = {}, ViewerId who = kAda) {
    std::array<double, 2> sum{};
    for (std::uint32_t n = 0; n < 25; ++n) {
      say(who, n);
      const auto block = mix.mix(room, {}, volumes, begin + n * 20ms);
      if (n < 10) continue;
      for (std::size_t i = 0; i < block.size(); ++i) sum[i % 2] += block[i] * block[i];
    }
    for (double& side : sum) side = std::sqrt(side / (15 * voice::kPacketSamples));
    return sum;
  }

  client::RoomSnapshot room;
  voice::VoiceEncoder encoder;
  RoomMix mix;
  const HostTime begin{1000s};
};

TEST_F(RoomMixTest, who_stands_on_the_left_is_heard_on_the_left) {
  const auto [left, right] = heard();
  EXPECT_NEAR(left, 0.2 / std::sqrt(2), 0.03);
  EXPECT_LT(right, 0.01);
}

TEST_F(RoomMixTest, who_is_far_is_quieter) {
  const auto [left, right] = heard({}, kBob);
  EXPECT_LT(left, 0.01);
  EXPECT_NEAR(right, 0.2 / std::sqrt(2) / 2.6, 0.02) << "3 m away, by the law of the page";
}

TEST_F(RoomMixTest, everybodys_volume_is_their_own) {
  EXPECT_LT(heard({{kAda, 0.F}})[0], 1e-6);
  EXPECT_EQ(mix.speakers(), std::set<ViewerId>{kAda});
}

TEST_F(RoomMixTest, who_is_nowhere_is_heard_in_the_middle) {
  const auto [left, right] = heard({}, ViewerId{77});
  EXPECT_NEAR(left, right, 1e-3);
  EXPECT_GT(left, 0.05);
}

TEST_F(RoomMixTest, many_speakers_take_bounded_memory) {
  for (std::uint32_t id = 0; id < 200; ++id) say(ViewerId{id}, id);
  EXPECT_EQ(mix.speakers().size(), RoomMix::kMaxSpeakers);
  const auto block = mix.mix(room, {}, {}, begin + 10s);
  for (const float sample : block) EXPECT_LE(std::abs(sample), 1);
}

}  // namespace
}  // namespace roomcast::viewer
