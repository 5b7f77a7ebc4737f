// SPDX-License-Identifier: Apache-2.0
// RoomState: a viewer's copy of the room, built from the hub's messages: rosters and frames in,
// snapshots out. No sockets; the clock is injected. Single-threaded.
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
  /// `clock` outlives this and gives the times at which frames are received and decoded.
  explicit RoomState(const Clock& clock) : clock_(clock) {}

  void welcome(const wire::pb::Welcome& welcome);
  /// kMalformed: a sensor's calibration or pose is invalid; the sensors before it are applied.
  Status roster(const wire::pb::Roster& roster);
  /// Ignores people who are not in the roster (yet, or any more).
  void poses(const wire::pb::ViewerPoses& poses);
  void voices(const wire::pb::Voices& voices);
  /// The sensors whose frames the hub leaves out, wholly or in part. Ignores unknown ones.
  void unseen(const wire::pb::UnseenSensors& unseen);
  /// The set has no more frames. False: it was complete before.
  bool set_ended(SetId set);
  void marks(const wire::pb::Marks& marks);
  void clock_is(const ClockEstimate& estimate) { room_.clock = estimate; }
  void disconnected(std::string problem);

  enum class FrameOutcome {
    kDecoded,
    kSetComplete,  // decoded, and the last of its set
    kNeedsKey,     // cannot be decoded without a key frame: ask for one
  };
  /// `message`: header and payload. kMalformed: not a frame, or of an unknown sensor.
  Result<FrameOutcome> frame(std::span<const std::uint8_t> message);

  /// The current state, with the next revision.
  [[nodiscard]] std::shared_ptr<const RoomSnapshot> snapshot();

 private:
  static constexpr std::uint32_t kLongestGap = 100'000;  // more: the numbering restarted
  struct SensorDecoding {
    std::uint64_t count_gap(const wire::FrameHeader& header);

    std::optional<std::uint32_t> newest_seq;
    bool is_small = false;  // the newest frame
    bool has_gaps = false;  // the hub leaves frames out
    std::unique_ptr<codec::FrameDecoder> decoder;
    FrameChain chain;
    std::vector<std::shared_ptr<SensorPicture>>
        pool;  // pictures are reused once no snapshot refers to them
  };

  void forget_others(const wire::pb::Roster& roster);
  Status update_sensor(const wire::pb::SensorEntry& entry);
  void update_people(const wire::pb::Roster& roster);
  void update_voices();
  std::shared_ptr<SensorPicture> free_picture(SensorDecoding& decoding);

  const Clock& clock_;
  RoomSnapshot room_;
  RoomMarks marks_;
  wire::pb::Voices voices_;
  SetId complete_set_{};  // the newest complete one
  std::unordered_map<SensorId, SensorDecoding> decoding_;
};

}  // namespace roomcast::client
