// SPDX-License-Identifier: Apache-2.0
// EchoCanceller: removes from a microphone's sound what the loudspeaker plays, as far as it comes
// back within kTail, and noise that goes on. speexdsp's adaptive filter (J.-M. Valin, "On adjusting
// the learning rate in frequency domain echo cancellation with double-talk", 2007) and its
// preprocessor. Single-threaded.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <span>

#include "roomcast/voice/voice_decoder.h"

// The types of speexdsp.
struct SpeexEchoState_;
struct SpeexPreprocessState_;

namespace roomcast::voice {

class EchoCanceller {
 public:
  /// From handing a block to the loudspeaker to the last echo of it in the room.
  static constexpr std::chrono::milliseconds kTail{300};

  EchoCanceller();

  /// `heard`: what the microphone recorded, which becomes what was said near it. `played`: what was
  /// handed to the loudspeaker in the same 20 ms, or up to kTail earlier.
  void process(std::span<float, kPacketSamples> heard,
               std::span<const float, kPacketSamples> played);
  /// Another microphone or loudspeaker: what was learnt is no more true.
  void restart();

 private:
  struct DestroyEcho {
    void operator()(SpeexEchoState_* state) const;
  };
  struct DestroyPreprocess {
    void operator()(SpeexPreprocessState_* state) const;
  };
  std::unique_ptr<SpeexEchoState_, DestroyEcho> echo_;
  std::unique_ptr<SpeexPreprocessState_, DestroyPreprocess> preprocess_;
};

}  // namespace roomcast::voice
