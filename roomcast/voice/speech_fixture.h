// SPDX-License-Identifier: Apache-2.0
// For tests: something like speech, made of a voice's pulses, formants and hisses, and the response
// of a room. Simulated, from fixed seeds; after Klatt, "Software for a cascade/parallel formant
// synthesizer" (JASA 1980), much simplified. 48 kHz.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "roomcast/voice/voice_decoder.h"

namespace roomcast::voice {

/// A resonance: two poles.
class Formant {
 public:
  void tune(double frequency_hz, double width_hz) {
    const double radius = std::exp(-std::numbers::pi * width_hz / kVoiceRate_hz);
    first_ = 2 * radius * std::cos(2 * std::numbers::pi * frequency_hz / kVoiceRate_hz);
    second_ = -radius * radius;
    gain_ = 1 - first_ - second_;
  }
  double step(double in) {
    const double out = gain_ * in + first_ * before_ + second_ * before_that_;
    before_that_ = std::exchange(before_, out);
    return out;
  }

 private:
  double first_ = 0, second_ = 0, gain_ = 1, before_ = 0, before_that_ = 0;
};

/// Syllables of 120 to 300 ms, most voiced, some hissed, with pauses; RMS over all about 0.1.
inline std::vector<float> speech_like(double seconds, std::uint32_t seed, double pitch_hz) {
  constexpr std::array<std::array<double, 3>, 5> kVowels = {{{730, 1090, 2440},
                                                             {270, 2290, 3010},
                                                             {300, 870, 2240},
                                                             {530, 1840, 2480},
                                                             {570, 840, 2410}}};
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::normal_distribution<double> noise(0, 1);
  std::array<Formant, 3> formants;
  const auto length = static_cast<std::size_t>(seconds * kVoiceRate_hz);
  std::vector<float> sound;
  sound.reserve(length);
  double phase = 0;
  while (sound.size() < length) {
    const bool is_pause = unit(random) < 0.15, is_hiss = unit(random) < 0.15;
    const auto count = static_cast<std::size_t>((0.12 + 0.18 * unit(random)) * kVoiceRate_hz);
    const auto& vowel = kVowels[static_cast<std::size_t>(unit(random) * 4.999)];
    for (std::size_t i = 0; i < 3; ++i)
      formants[i].tune(is_hiss ? 3500 + 900 * static_cast<double>(i) : vowel[i],
                       is_hiss ? 900 : 90);
    const double pitch = pitch_hz * (0.85 + 0.3 * unit(random));
    for (std::size_t i = 0; i < count && sound.size() < length; ++i) {
      const double part = static_cast<double>(i) / static_cast<double>(count);
      const double swell = is_pause ? 0 : std::sin(std::numbers::pi * part);
      phase += pitch * (1 + 0.1 * part) / kVoiceRate_hz;
      double source = 0.02 * noise(random);
      if (is_hiss) source = 0.6 * noise(random);
      if (phase >= 1 && !is_hiss) source += 14;
      phase -= std::floor(phase);
      double sum = 0;
      for (Formant& formant : formants) sum += formant.step(swell * source);
      sound.push_back(static_cast<float>(sum));
    }
  }
  double energy = 0;
  for (const float sample : sound) energy += static_cast<double>(sample) * sample;
  const auto scale =
      static_cast<float>(0.1 / std::sqrt(energy / static_cast<double>(sound.size())));
  for (float& sample : sound) sample = std::clamp(scale * sample, -0.95F, 0.95F);
  return sound;
}

/// From what a loudspeaker is handed to a microphone: `delay_s` of devices and air, then a direct
/// path and reflections that decay by 60 dB in `decay_s`.
inline std::vector<float> room_response(double delay_s, double decay_s, double loudness,
                                        std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, 1);
  const auto begin = static_cast<std::size_t>(delay_s * kVoiceRate_hz);
  const auto length = static_cast<std::size_t>(0.8 * decay_s * kVoiceRate_hz);
  std::vector<float> response(begin + length);
  response[begin] = static_cast<float>(loudness);
  for (std::size_t i = 24; i < length; i += 4) {
    const double t_s = static_cast<double>(i) / kVoiceRate_hz;
    response[begin + i] =
        static_cast<float>(0.1 * loudness * noise(random) * std::exp(-6.9 * t_s / decay_s));
  }
  return response;
}

/// `sound` as it comes through `response`, of the same length. Exact; only for short sounds.
inline std::vector<float> through(const std::vector<float>& sound,
                                  const std::vector<float>& response) {
  std::vector<float> out(sound.size());
  for (std::size_t k = 0; k < response.size(); ++k) {
    if (response[k] == 0) continue;
    for (std::size_t i = k; i < sound.size(); ++i) out[i] += response[k] * sound[i - k];
  }
  return out;
}

}  // namespace roomcast::voice
