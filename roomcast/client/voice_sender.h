// SPDX-License-Identifier: Apache-2.0
// VoiceSender: numbers and frames the audio packets of this viewer or sensor (docs/spec/wire.md
// section 6). Packets that the network has no room for are dropped, oldest first; the numbering
// tells listeners. Single-threaded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>

#include "roomcast/client/room/clock_estimate.h"
#include "roomcast/core/clock.h"
#include "roomcast/net/framed_message.h"

namespace roomcast::client {

class VoiceSender {
 public:
  static constexpr std::size_t kMaxWaiting = 100;  // 2 s

  /// On each welcome: numbers begin at 0, and the room's clock is not known yet.
  void joined();
  void clock_is(const ClockEstimate& estimate) { clock_ = estimate; }
  /// There is no connection.
  void lost();

  /// `opus`: at most wire::kMaxAudioPayloadBytes. Dropped while there is no connection, or no room
  /// time.
  void say(std::span<const std::uint8_t> opus, bool ends, HostTime first_sample);

  /// Null: nothing waits.
  [[nodiscard]] net::FramedMessagePtr next();

 private:
  std::optional<ClockEstimate> clock_;
  std::uint32_t seq_ = 0;
  std::deque<net::FramedMessagePtr> waiting_;
};

}  // namespace roomcast::client
