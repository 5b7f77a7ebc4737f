// SPDX-License-Identifier: Apache-2.0
// FrameSynchronizer: groups the frames of a room's sensors into frame sets by capture time
// (docs/spec/wire.md §3, "Frame sets"). A set closes when every sensor that is due in it has
// delivered, or at its deadline, so that slow sensors delay nobody. Pure: time is an argument.
// Memory is bounded by the two limits below.
#pragma once

#include <array>
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
  /// Open sets at the same time; when one more opens, the oldest closes as it is.
  static constexpr std::size_t kMaxOpenSets = 8;
  /// Frames of one sensor in one set; more than one only while the sensor catches up.
  static constexpr std::size_t kMaxFramesOfSensorInSet = 4;

  /// Adds a sensor that delivers `fps` frames a second. Sets do not wait for it before its first
  /// frame. `other_hub`: the hub to which the sensor is connected; 0: this hub. When another hub
  /// marks a frame as the last of its set, this set no longer waits for the other sensors of that
  /// hub.
  void add_sensor(SensorId sensor, double fps, std::uint64_t other_hub = 0);
  /// Removes a sensor; sets no longer wait for it.
  void remove_sensor(SensorId sensor);

  /// Sets do not wait for the sensor while it is paused, nor from then on before its next frame.
  void pause_sensor(SensorId sensor, bool is_paused);

  /// The room's frame rate: the highest of its sensors, in Hz; 0 without sensors.
  [[nodiscard]] double fps() const;

  /// Takes a frame that wire::parse_frame accepted, of a sensor that was added. False: the frame
  /// was discarded, because its set already has kMaxFramesOfSensorInSet frames of this sensor. A
  /// frame of a small rendition waits for the sensor's next other frame, and is in its set.
  bool add_frame(const wire::FrameHeader& header, net::MessageBuffer message, RoomTime now);

  /// Returns the closed sets in order: complete ones, and those whose deadline has passed.
  [[nodiscard]] std::vector<FrameSetPtr> take_closed(RoomTime now);

  /// The next time at which take_closed() has a set if no other frame arrives; nothing: no set is
  /// open.
  [[nodiscard]] std::optional<RoomTime> next_deadline() const;

 private:
  using Slot = std::int64_t;  // k of the spec: the number of frame periods since room time 0

  struct Pending {
    wire::FrameHeader header;
    net::MessageBuffer message;
  };
  struct Sensor {
    double fps = 0;
    std::uint64_t other_hub = 0;
    bool is_paused = false;
    std::array<nanoseconds, 2> gaps{};  // between its last captures, the newest first; 0: unknown
    struct Delivery {
      Slot slot = 0;
      bool is_late = false;  // its capture time belongs to an earlier slot
      std::size_t frames_in_slot = 0;
      RoomTime capture_time{};
      RoomTime arrival_time{};
    };
    std::optional<Delivery> last;
    std::vector<Pending> small = {};  // of its small rendition, whose sets are not known yet
  };
  struct OpenSet {
    RoomTime deadline{};
    std::vector<Pending> frames;
  };

  struct OtherHub {
    Slot newest = 0;  // slot of its newest frame since it last closed a set
    Slot closed = 0;  // no more frames come for slots up to this one
  };

  void follow_rate();
  void note_closing(std::uint64_t other_hub, Slot slot, bool is_last);
  [[nodiscard]] static nanoseconds interval_of(const Sensor& sensor);
  [[nodiscard]] Slot natural_slot(RoomTime capture) const;
  [[nodiscard]] std::optional<Slot> assign_slot(const Sensor& sensor, RoomTime capture) const;
  [[nodiscard]] bool is_due(const Sensor& sensor, Slot slot, RoomTime deadline, RoomTime now) const;
  [[nodiscard]] bool is_complete(Slot slot, RoomTime deadline, RoomTime now) const;
  void close_oldest();

  std::unordered_map<SensorId, Sensor> sensors_;
  std::unordered_map<std::uint64_t, OtherHub> other_hubs_;
  nanoseconds period_{};  // of the room; 0 without sensors
  std::map<Slot, OpenSet> open_;
  std::optional<Slot> newest_closed_;  // slots up to this one take no more frames
  std::uint64_t next_set_id_ = 1;
  std::vector<FrameSetPtr> closed_;  // not yet taken
};

}  // namespace roomcast::hub
