// SPDX-License-Identifier: Apache-2.0
// TalkGate: decides which blocks of 20 ms are sent: those with a voice, or those while a key is
// held. A voice is what is clearly louder than the room's own noise, which is the least loudness of
// the last seconds; as in web/src/voice/talk_gate.ts. Single-threaded.
#pragma once

#include <span>

#include "roomcast/voice/voice_decoder.h"

namespace roomcast::voice {

enum class TalkMode { kVoice, kPush };

/// Root of the mean square; 1 is full scale.
[[nodiscard]] double loudness_of(std::span<const float> samples);

class TalkGate {
 public:
  /// Whether the block is sent.
  [[nodiscard]] bool is_open(std::span<const float> samples, TalkMode mode, bool is_pushed);

 private:
  static constexpr double kQuietest = 0.0017782794;  // -55 dB; below it nothing counts as a voice

  void learn_noise(double loudness);

  int hang_ = 0;
  double noise_ = kQuietest;
  double least_ = 1e9;
  int blocks_ = 0;
};

}  // namespace roomcast::voice
