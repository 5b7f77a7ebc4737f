// SPDX-License-Identifier: Apache-2.0
// RoomStats: counters and state of a room for the hub's operator.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/geometry/sensor_pose.h"
#include "roomcast/hub/room/frame_set.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

/// How much the infrared light of other sensors disturbs a sensor, by its own report.
struct SensorInterference {
  double flickering = 0;   // share of the readings of still surfaces that are missing
  double noise_ratio = 1;  // largest noise of the last seconds, in the sensor's usual noise
  std::string neighbour;   // the sensor that lights most of what this one sees; empty: unknown
  double shared = 0;       // the share of this sensor's view that it lights
  std::string advice;      // for people; empty: nothing needs to be done
};

struct SensorStats {
  SensorId id = {};
  std::string name = {};
  bool online = false;
  ConnectionId connection = {};  // while online
  std::string token_id = {};     // of the token that it joined with
  SensorPose pose = {};
  std::optional<SensorInterference> interference = {};
  std::optional<wire::pb::SensorSettings> settings = {};  // while online; nothing: it takes none
  std::uint64_t frames = 0;
  std::uint64_t bytes = 0;
  std::optional<std::uint32_t> newest_seq = {};  // nothing: no gap before the next frame
  std::uint64_t missed = 0;  // gaps in its sequence numbers: frames that did not arrive
  std::optional<double> clock_error_s = {};  // the bound that the sensor states in its newest frame
  double delay_s = 0;  // of its newest frame, from capture to arrival at the hub
  double frames_per_s = 0, bytes_per_s = 0;  // over the last second or so
  bool is_unseen = false;                    // it sends no frames, because nobody sees it
  double share_mbit = 0;                     // of the room's uplink; 0: it sends as it likes
  bool has_microphone = false;               // it has been heard since the sensor joined
  bool speaks = false;                       // its microphone is heard at present
  bool muted = false;                        // its microphone, by an admin
};

struct ViewerStats {
  ViewerId id = {};
  std::string name = {};
  ConnectionId connection = {};
  std::string token_id = {};  // of the token that it joined with
  bool records = false;
  std::string plays = {};  // a recording, instead of being in the room; empty: it is in the room
  bool may_speak = false;
  bool speaks = false;                  // at present
  bool muted = false;                   // by an admin
  float shown_fps = 0, latency_ms = 0;  // reported by the viewer; 0: not reported
  std::uint64_t bytes = 0;              // sent to it
  std::uint64_t dropped_sets = 0;       // dropped because it reads too slowly
  std::uint64_t dropped_audio = 0;      // packets, for the same reason
  double bytes_per_s = 0;               // over the last second or so
  std::size_t small_sensors = 0;  // of which it gets the small rendition, as its line takes no more
};

struct RoomStats {
  std::string room;
  std::vector<SensorStats> sensors = {};
  std::vector<ViewerStats> viewers = {};
  std::uint64_t sets = 0;             // closed
  std::uint64_t incomplete_sets = 0;  // without a frame of some sensor that was online
  std::uint64_t dropped_sets = 0;     // dropped for slow viewers, over all viewers so far
  double set_skew_s = 0;              // between the first and last capture in the newest set
  std::size_t speakers = 0;           // at present
  std::uint64_t audio_packets = 0;    // received
  bool frames_wanted = false;         // else its sensors send none, because nobody watches
};

/// The time between the first and the last capture in a set. Only the newest frame of each sensor
/// counts.
[[nodiscard]] nanoseconds capture_skew(const FrameSet& set);
[[nodiscard]] std::size_t sensor_count(const FrameSet& set);

/// Count an arrived frame, and a set that closed while `online_sensors` sensors were online.
void count_frame(const wire::FrameHeader& header, std::size_t bytes, RoomTime now,
                 SensorStats& stats);
void count_set(const FrameSet& set, std::size_t online_sensors, RoomStats& stats);

}  // namespace roomcast::hub
