// SPDX-License-Identifier: Apache-2.0
// SpokenVoice: makes packets of what a program says, with the times at which it was said. Refuses
// what no microphone gives: more than real time, over which a hub would end the connection.
// Samples: 48 kHz, one channel. Single-threaded.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/result.h"
#include "roomcast/voice/voice_encoder.h"

namespace roomcast::client {

struct SpokenPacket {
  std::vector<std::uint8_t> opus;
  bool ends = false;
  HostTime first_sample{};
};

class SpokenVoice {
 public:
  static constexpr std::chrono::seconds kMaxAtOnce{1};
  /// A speaker who falls behind by more than this counts as having paused.
  static constexpr std::chrono::milliseconds kMaxBehind{200};

  /// `samples` were recorded just before `now`. kTooLarge: more than kMaxAtOnce, or said faster
  /// than in real time; nothing of it is said.
  [[nodiscard]] Result<std::vector<SpokenPacket>> say(std::span<const float> samples, HostTime now);
  /// The last packet before a pause, filled up with silence; nothing if nothing was said.
  [[nodiscard]] std::optional<SpokenPacket> pause();

 private:
  [[nodiscard]] HostTime begin(nanoseconds length, HostTime now) const;
  [[nodiscard]] SpokenPacket packet(std::span<const float> samples, bool ends);

  voice::VoiceEncoder encoder_;
  std::vector<float> left_over_;  // less than a packet
  bool speaking_ = false;
  HostTime next_sample_{};              // when the sample after the last one was recorded
  std::optional<HostTime> said_until_;  // ever
};

}  // namespace roomcast::client
