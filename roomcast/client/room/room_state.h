// SPDX-License-Identifier: Apache-2.0
// RoomState: a viewer's copy of the room, built from what the hub sends: roster in, frames in,
// snapshots out. No sockets; its only clock is the one it is given. Single-threaded.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "roomcast/client/room/frame_chain.h"
#include "roomcast/client/room/room_snapshot.h"
#include "roomcast/codec/frame_codec.h"
#include "roomcast/core/result.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::client {

class RoomState {
 public:
  /// `clock` outlives this: it says when frames were received and decoded.
  explicit RoomState(const Clock& clock) : clock_(clock) {}

  void welcome(const wire::pb::Welcome& welcome);
  /// kMalformed when a sensor's calibration makes no sense; the sensors before it are taken.
  Status roster(const wire::pb::Roster& roster);
  /// Of people who are not in the roster (yet, or any more) nothing is shown.
  void poses(const wire::pb::ViewerPoses& poses);
  void clock_is(const ClockEstimate& estimate) { room_.clock = estimate; }
  void disconnected(std::string problem);

  enum class FrameOutcome {
    kDecoded,
    kSetComplete,  // decoded, and the last of its set
    kNeedsKey,     // cannot be decoded without a key frame: ask for one
  };
  /// `message`: header and payload. kMalformed: not a frame, or of an unknown sensor.
  Result<FrameOutcome> frame(std::span<const std::uint8_t> message);

  /// As of now, with the next revision.
  [[nodiscard]] std::shared_ptr<const RoomSnapshot> snapshot();

 private:
  static constexpr std::uint32_t kLongestGap = 100'000;  // more means that it counts anew
  struct SensorDecoding {
    std::uint64_t count_gap(std::uint32_t seq);

    std::optional<std::uint32_t> newest_seq;
    std::unique_ptr<codec::FrameDecoder> decoder;
    FrameChain chain;
    std::vector<std::shared_ptr<SensorPicture>>
        pool;  // pictures are used again once nobody looks at them
  };

  void forget_others(const wire::pb::Roster& roster);
  Status update_sensor(const wire::pb::SensorEntry& entry);
  void update_people(const wire::pb::Roster& roster);
  std::shared_ptr<SensorPicture> free_picture(SensorDecoding& decoding);

  const Clock& clock_;
  RoomSnapshot room_;
  std::unordered_map<SensorId, SensorDecoding> decoding_;
};

}  // namespace roomcast::client
