// SPDX-License-Identifier: Apache-2.0
// VoiceTrack: one speaker's packets in the order of arrival become samples at their places in time.
// What is said without a pause stays without gaps although capture times vary a little; lost
// packets are concealed as long as a listener would (60 ms). Time: samples at 48 kHz since the
// recording began. Single-threaded.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "roomcast/core/clock.h"
#include "roomcast/voice/voice_decoder.h"

namespace roomcast::recording {

struct VoicePacket {
  std::uint32_t seq = 0;
  bool ends = false;   // the speaker pauses after it
  nanoseconds time{};  // of the first sample, since the recording began
  std::span<const std::uint8_t> opus;
};

class VoiceTrack {
 public:
  static constexpr std::uint32_t kMaxConcealed = 3;  // packets
  /// A packet that is farther from where the one before ended is put at its own time.
  static constexpr std::int64_t kMaxShifted = voice::kPacketSamples / 2;

  /// 960 samples that belong at `at`.
  using Out = std::function<void(std::int64_t at, std::span<const float> samples)>;

  /// Packets that were there already, or come too late, are left out.
  void take(const VoicePacket& packet, const Out& out);

  struct Figures {
    std::uint64_t packets = 0;    // decoded
    std::uint64_t concealed = 0;  // lost or broken
  };
  [[nodiscard]] const Figures& figures() const { return figures_; }

 private:
  [[nodiscard]] std::int64_t place(std::int64_t at) const;
  void fill_gap(std::uint32_t lost, std::int64_t at, const Out& out);

  voice::VoiceDecoder decoder_;
  std::optional<std::uint32_t> next_seq_;  // nothing: nothing was said yet
  std::optional<std::int64_t> end_;        // of what was said last; nothing: the speaker has paused
  Figures figures_;
};

}  // namespace roomcast::recording
