// SPDX-License-Identifier: Apache-2.0
// JitterBuffer: plays the packets of one speaker evenly although they arrive unevenly: waits for
// late ones as long as pays (DelayEstimate), and conceals up to three that are lost. The delay is
// set where somebody begins to speak, and where it has grown so much that packets are left out.
// Single-threaded.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/voice/delay_estimate.h"
#include "roomcast/voice/voice_decoder.h"

namespace roomcast::voice {

struct SpokenBlock {
  std::uint32_t seq = 0;
  bool ends = false;      // the speaker pauses after it
  nanoseconds capture{};  // of the first sample, by the clock of the room
  std::vector<std::uint8_t> opus;
};

class JitterBuffer {
 public:
  static constexpr int kMaxConcealed = 3;         // packets, 60 ms: then the speaker has paused
  static constexpr std::size_t kMaxWaiting = 50;  // packets, a second
  static constexpr double kMaxBehind_ms = 100;    // of the target: then packets are left out

  using Block = std::array<float, kPacketSamples>;

  void push(SpokenBlock block, nanoseconds now);
  /// What is to be heard in the 20 ms from `now` on; nothing: silence.
  [[nodiscard]] std::optional<Block> pull(nanoseconds now);

  struct Figures {
    std::uint64_t played = 0, concealed = 0, skipped = 0;  // packets
  };
  [[nodiscard]] const Figures& figures() const { return figures_; }
  [[nodiscard]] double target_ms() const { return delay_.target_ms(); }

 private:
  [[nodiscard]] bool begin(nanoseconds now);
  [[nodiscard]] double late_ms(nanoseconds capture, nanoseconds now) const;
  void skip_first();
  void restart();
  [[nodiscard]] std::optional<Block> conceal();
  [[nodiscard]] std::int64_t unwrapped(std::uint32_t seq) const;

  VoiceDecoder decoder_;
  DelayEstimate delay_;
  std::map<std::int64_t, SpokenBlock> waiting_;  // by number, which does not wrap
  std::optional<std::int64_t> newest_;
  bool is_playing_ = false;
  std::int64_t next_ = 0;  // while playing
  int concealed_ = 0;      // since the last packet
  Figures figures_;
};

}  // namespace roomcast::voice
