// SPDX-License-Identifier: Apache-2.0
// VoiceEncoder: encodes one speaker's voice with libopus (RFC 6716) as the page does: 20 ms of one
// channel at 48 kHz in each packet, 32 kbit/s. Single-threaded.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "roomcast/voice/voice_decoder.h"

struct OpusEncoder;

namespace roomcast::voice {

inline constexpr int kVoiceBitsPerSecond = 32'000;

class VoiceEncoder {
 public:
  VoiceEncoder();

  /// `samples`: -1 to 1; values that are no numbers count as silence.
  [[nodiscard]] std::vector<std::uint8_t> encode(std::span<const float, kPacketSamples> samples);
  /// The speaker begins anew.
  void restart();

 private:
  struct Destroy {
    void operator()(OpusEncoder* encoder) const;
  };
  std::unique_ptr<OpusEncoder, Destroy> encoder_;
};

}  // namespace roomcast::voice
