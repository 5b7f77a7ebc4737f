// SPDX-License-Identifier: Apache-2.0
// RoomMix: the voices of a room as a listener hears them: each evenly (voice::JitterBuffer), from
// its place (sound::listener_gains, as in films and exported sound), with a volume of its own.
// Single-threaded.
#pragma once

#include <cstddef>
#include <map>
#include <set>

#include "roomcast/client/heard_voices.h"
#include "roomcast/client/room/room_snapshot.h"
#include "roomcast/sound/listener_gains.h"
#include "roomcast/sound/loudspeaker.h"
#include "roomcast/voice/jitter_buffer.h"

namespace roomcast::viewer {

class RoomMix {
 public:
  static constexpr std::size_t kMaxSpeakers = 64;  // whose packets are kept

  /// A packet has come.
  void take(client::HeardPacket packet, HostTime now);
  /// The next 20 ms. `world_from_head`: the listener's.
  [[nodiscard]] sound::StereoBlock mix(const client::RoomSnapshot& room,
                                       const RigidTransform& world_from_head,
                                       const std::map<ViewerId, float>& volumes, HostTime now);
  [[nodiscard]] std::set<ViewerId> speakers() const;

 private:
  struct Speaker {
    voice::JitterBuffer buffer;
    HostTime newest{};     // packet
    sound::Gains gains{};  // of the last block
    bool was_heard = false;
  };
  void add(Speaker& speaker, const voice::JitterBuffer::Block& block, const sound::Gains& gains,
           sound::StereoBlock& out);

  std::map<ViewerId, Speaker> speakers_;
};

}  // namespace roomcast::viewer
