// SPDX-License-Identifier: Apache-2.0
// RoomState: a viewer's copy of the room, built from what the hub sends: roster in, frames in,
// snapshots out. Pure (no sockets, no clocks), single-threaded.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "roomcast/codec/frame_codec.h"
#include "roomcast/core/result.h"
#include "roomcast/room/frame_chain.h"
#include "roomcast/room/room_snapshot.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast {

class RoomState {
 public:
  void welcome(const wire::pb::Welcome& welcome);
  /// kMalformed when a sensor's calibration makes no sense; the sensors before it are taken.
  Status roster(const wire::pb::Roster& roster);
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
  struct SensorDecoding {
    std::unique_ptr<codec::FrameDecoder> decoder;
    FrameChain chain;
    std::vector<std::shared_ptr<SensorPicture>>
        pool;  // pictures are used again once nobody looks at them
  };

  Status update_sensor(const wire::pb::SensorEntry& entry);
  std::shared_ptr<SensorPicture> free_picture(SensorDecoding& decoding);

  RoomSnapshot room_;
  std::unordered_map<SensorId, SensorDecoding> decoding_;
};

}  // namespace roomcast
