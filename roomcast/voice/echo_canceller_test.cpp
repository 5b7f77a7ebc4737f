// SPDX-License-Identifier: Apache-2.0
// How far down the echo of a loudspeaker is, and what is left of a voice beside it: simulated, with
// speech-like sounds and a room's response. Prints the figures of docs/guides/viewer.md.
#include "roomcast/voice/echo_canceller.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/voice/speech_fixture.h"

namespace roomcast::voice {
namespace {

using Sound = std::vector<float>;

constexpr std::size_t kSecond = kVoiceRate_hz;

Sound cancelled(const Sound& heard, const Sound& played) {
  EchoCanceller canceller;
  Sound out = heard;
  for (std::size_t at = 0; at + kPacketSamples <= out.size(); at += kPacketSamples)
    canceller.process(std::span(out).subspan(at).first<kPacketSamples>(),
                      std::span(played).subspan(at).first<kPacketSamples>());
  return out;
}

double energy(const Sound& sound, std::size_t from, std::size_t to) {
  double sum = 1e-12;
  for (std::size_t i = from; i < to; ++i) sum += static_cast<double>(sound[i]) * sound[i];
  return sum;
}

double in_db(double ratio) {
  return 10 * std::log10(ratio);
}

/// How much of `voice` is in `sound`, delayed as it is there; 1: all.
double share_of(const Sound& voice, const Sound& sound, std::size_t from, std::size_t to) {
  double best = 0;
  for (std::size_t delay = 0; delay <= 2 * kPacketSamples; ++delay) {
    double product = 0;
    for (std::size_t i = from; i < to; i += 3)
      product += static_cast<double>(voice[i - delay]) * sound[i];
    best = std::max(best, product);
  }
  return best / (energy(voice, from, to) / 3);
}

Sound sum_of(Sound a, const Sound& b) {
  std::ranges::transform(a, b, a.begin(), std::plus<>());
  return a;
}

TEST(EchoCanceller, an_echo_is_30_dB_down_and_a_voice_beside_it_is_kept) {
  constexpr std::size_t kLearns = 10 * kSecond, kAlone = 15 * kSecond, kEnd = 20 * kSecond;
  const Sound played = speech_like(20, 1, 120);
  const Sound echo = through(played, room_response(0.08, 0.2, 0.5, 2));
  Sound voice = speech_like(20, 3, 210);
  std::fill_n(voice.begin(), kAlone, 0.F);  // it comes in after 15 s
  const Sound out = cancelled(sum_of(echo, voice), played);
  const double down_db = in_db(energy(echo, kLearns, kAlone) / energy(out, kLearns, kAlone));
  const double kept_db = 2 * in_db(share_of(voice, out, kAlone + kSecond, kEnd));
  std::printf("simulated: echo %.1f dB down; the voice beside it %+.1f dB\n", down_db, kept_db);
  EXPECT_GE(down_db, 30);
  EXPECT_GE(kept_db, -6);
}

TEST(EchoCanceller, a_voice_without_an_echo_passes) {
  const Sound voice = speech_like(6, 5, 150), silence(voice.size());
  const Sound out = cancelled(voice, silence);
  EXPECT_GE(2 * in_db(share_of(voice, out, 3 * kSecond, 6 * kSecond)), -3);
}

TEST(EchoCanceller, noise_that_goes_on_gets_quieter) {
  std::mt19937 random(1);
  std::normal_distribution<float> hum(0, 0.01F);
  Sound noise(8 * kSecond), silence(noise.size());
  for (float& sample : noise) sample = hum(random);
  const Sound out = cancelled(noise, silence);
  EXPECT_GE(in_db(energy(noise, 6 * kSecond, 8 * kSecond) / energy(out, 6 * kSecond, 8 * kSecond)),
            10);
}

}  // namespace
}  // namespace roomcast::voice
