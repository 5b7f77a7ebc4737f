// SPDX-License-Identifier: Apache-2.0
#include "roomcast/voice/talk_gate.h"

#include <algorithm>
#include <cmath>

namespace roomcast::voice {
namespace {

constexpr double kAboveNoise = 3;        // 10 dB
constexpr int kHangBlocks = 20;          // 400 ms, so that words are not cut off
constexpr int kNoiseWindowBlocks = 150;  // 3 s
constexpr double kNone = 1e9;            // louder than anything

}  // namespace

double loudness_of(std::span<const float> samples) {
  double sum = 0;
  for (const float sample : samples) sum += static_cast<double>(sample) * sample;
  return samples.empty() ? 0 : std::sqrt(sum / static_cast<double>(samples.size()));
}

bool TalkGate::is_open(std::span<const float> samples, TalkMode mode, bool is_pushed) {
  const double loudness = loudness_of(samples);
  learn_noise(loudness);
  if (mode == TalkMode::kPush) return is_pushed;
  if (loudness > std::max(kQuietest, kAboveNoise * noise_)) {
    hang_ = kHangBlocks;
  } else if (hang_ > 0) {
    --hang_;
  }
  return hang_ > 0;
}

void TalkGate::learn_noise(double loudness) {
  least_ = std::min(least_, loudness);
  noise_ = std::min(noise_, std::max(loudness, kQuietest / kAboveNoise));
  if (++blocks_ % kNoiseWindowBlocks != 0) return;
  noise_ = least_;
  least_ = kNone;
}

}  // namespace roomcast::voice
