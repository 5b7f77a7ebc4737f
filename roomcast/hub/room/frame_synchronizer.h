// SPDX-License-Identifier: Apache-2.0
// FrameSynchronizer: sorts the frames of a room's sensors into frame sets by capture time:
// docs/spec/wire.md §3, "Frame sets". A set closes when every sensor that is due in it has
// delivered, or at its deadline; it never waits for the slowest. Pure: time comes in as an
// argument. Memory: bounded by the two limits below.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/ids.h"
#include "roomcast/hub/room/frame_set.h"
#include "roomcast/net/message_buffer.h"
#include "roomcast/wire/frame_header.h"

namespace roomcast::hub {

class FrameSynchronizer {
 public:
  /// Sets that wait at the same time; when one more begins, the oldest closes as it is.
  static constexpr std::size_t kMaxOpenSets = 8;
  /// Of a sensor that catches up; normally it is one.
  static constexpr std::size_t kMaxFramesOfSensorInSet = 4;

  /// A sensor delivers from now on, `fps` frames a second. Nobody waits for it before its first
  /// frame. `other_hub`: at which it is, if it is at another one; 0: here. What that hub calls the
  /// last frame of a set says that none of its other sensors is still to come: nobody waits here,
  /// too, for whom was waited for there.
  void add_sensor(SensorId sensor, double fps, std::uint64_t other_hub = 0);
  /// It delivers no more; nobody waits for it.
  void remove_sensor(SensorId sensor);

  /// The room's rate: the highest of its sensors; 0 without sensors.
  [[nodiscard]] double fps() const;

  /// Takes a frame that wire::parse_frame accepted, of a sensor that was added. False: it came more
  /// than a period ahead of the room's rate and was discarded.
  bool add_frame(const wire::FrameHeader& header, net::MessageBuffer message, RoomTime now);

  /// Closed sets, in order: those that are complete, and those whose deadline is past.
  [[nodiscard]] std::vector<FrameSetPtr> take_closed(RoomTime now);

  /// When take_closed will next have something, if no other frame comes.
  [[nodiscard]] std::optional<RoomTime> next_deadline() const;

 private:
  using Slot = std::int64_t;  // k of the spec: counts frame periods since room time 0

  struct Sensor {
    double fps = 0;
    std::uint64_t other_hub = 0;
    struct Delivery {
      Slot slot = 0;
      bool is_late = false;  // it belonged to an earlier slot
      std::size_t frames_in_slot = 0;
      RoomTime capture_time{};
      RoomTime arrival_time{};
    };
    std::optional<Delivery> last;
  };
  struct Pending {
    wire::FrameHeader header;
    net::MessageBuffer message;
  };
  struct OpenSet {
    RoomTime deadline{};
    std::vector<Pending> frames;
  };

  struct OtherHub {
    Slot newest = 0;  // of its frames since it last closed a set
    Slot closed = 0;  // up to here nothing more comes
  };

  void follow_rate();
  void note_closing(std::uint64_t other_hub, Slot slot, bool is_last);
  [[nodiscard]] Slot natural_slot(RoomTime capture) const;
  [[nodiscard]] std::optional<Slot> assign_slot(const Sensor& sensor, RoomTime capture) const;
  [[nodiscard]] bool is_due(const Sensor& sensor, Slot slot, RoomTime deadline, RoomTime now) const;
  [[nodiscard]] bool is_complete(Slot slot, RoomTime deadline, RoomTime now) const;
  void close_oldest();

  std::unordered_map<SensorId, Sensor> sensors_;
  std::unordered_map<std::uint64_t, OtherHub> other_hubs_;
  nanoseconds period_{};  // of the room; 0 without sensors
  std::map<Slot, OpenSet> open_;
  std::optional<Slot> newest_closed_;  // slots up to here take no more frames
  std::uint64_t next_set_id_ = 1;
  std::vector<FrameSetPtr> closed_;  // not yet taken
};

}  // namespace roomcast::hub
