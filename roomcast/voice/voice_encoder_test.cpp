// SPDX-License-Identifier: Apache-2.0
#include "roomcast/voice/voice_encoder.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace roomcast::voice {
namespace {

using Packet = std::array<float, kPacketSamples>;

Packet tone(int nth) {
  Packet samples{};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto at = static_cast<float>(static_cast<std::size_t>(nth) * samples.size() + i);
    samples[i] = 0.5F * std::sin(2 * std::numbers::pi_v<float> * 440 * at / kVoiceRate_hz);
  }
  return samples;
}

double loudness(const Packet& samples) {
  double sum = 0;
  for (const float sample : samples) sum += double{sample} * sample;
  return std::sqrt(sum / static_cast<double>(samples.size()));
}

TEST(VoiceEncoder, a_tone_comes_back_as_loud_as_it_was) {
  VoiceEncoder encoder;
  VoiceDecoder decoder;
  Packet heard{};
  std::size_t bytes = 0;
  for (int i = 0; i < 50; ++i) {
    const auto packet = encoder.encode(tone(i));
    bytes += packet.size();
    ASSERT_TRUE(decoder.decode(packet, heard));
  }
  EXPECT_NEAR(loudness(heard), 0.5 / std::numbers::sqrt2, 0.05);
  EXPECT_LT(bytes * 8, 1.2 * kVoiceBitsPerSecond);
}

TEST(VoiceEncoder, what_is_no_sound_is_silence) {
  VoiceEncoder encoder;
  VoiceDecoder decoder;
  Packet broken{}, heard{};
  broken.fill(std::numeric_limits<float>::quiet_NaN());
  ASSERT_TRUE(decoder.decode(encoder.encode(broken), heard));
  EXPECT_LT(loudness(heard), 1e-3);
}

TEST(VoiceEncoder, begins_anew) {
  VoiceEncoder used, fresh;
  for (int i = 0; i < 20; ++i) (void)used.encode(tone(i));
  used.restart();
  EXPECT_EQ(used.encode(tone(0)), fresh.encode(tone(0)));
}

}  // namespace
}  // namespace roomcast::voice
