// SPDX-License-Identifier: Apache-2.0
// VoiceListener: decodes people's packets one after the other, and conceals up to three that were
// lost on their way, as the page does. Single-threaded.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>

#include "roomcast/client/heard_voices.h"
#include "roomcast/voice/voice_decoder.h"

namespace roomcast::client {

class VoiceListener {
 public:
  static constexpr std::uint32_t kMaxConcealed = 3;
  static constexpr std::size_t kMaxSpeakers = 64;  // whose decoders are kept

  struct Heard {
    HeardPacket packet;  // without Opus: it was lost
    std::array<float, voice::kPacketSamples> samples{};
  };

  /// Takes a packet that came; next() gives it, after those that were lost before it.
  void take(HeardPacket packet);
  [[nodiscard]] std::optional<Heard> next();

 private:
  struct Speaker {
    voice::VoiceDecoder decoder;
    std::optional<std::uint32_t> next_seq;
    std::uint64_t used = 0;
  };
  Speaker& speaker(ViewerId id);

  std::map<ViewerId, Speaker> speakers_;
  std::uint64_t uses_ = 0;
  std::deque<Heard> heard_;
};

}  // namespace roomcast::client
