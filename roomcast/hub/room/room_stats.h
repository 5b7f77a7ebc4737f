// SPDX-License-Identifier: Apache-2.0
// RoomStats: how a room is doing, for whoever runs the hub.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/hub/room/frame_set.h"
#include "roomcast/hub/room/sensor_place.h"

namespace roomcast::hub {

struct SensorStats {
  SensorId id = {};
  std::string name = {};
  bool online = false;
  ConnectionId connection = {};  // while online
  std::string token_id = {};     // that it came with
  SensorPlace place = {};
  std::uint64_t frames = 0;
  std::uint64_t bytes = 0;
  std::optional<std::uint32_t> newest_seq = {};  // nothing: the next frame follows none
  std::uint64_t missed = 0;                  // frames that it has numbered and that did not come
  std::optional<double> clock_error_s = {};  // the sensor's own bound, of its newest frame
  double delay_s = 0;                        // capture to connection_info, of its newest frame
  double frames_per_s = 0, bytes_per_s = 0;  // lately
};

struct ViewerStats {
  ViewerId id = {};
  std::string name = {};
  ConnectionId connection = {};
  std::string token_id = {};  // that it came with
  bool records = false;
  float shown_fps = 0, latency_ms = 0;  // by its own word; 0: it has not told
  std::uint64_t bytes = 0;              // sent to it
  std::uint64_t dropped_sets = 0;       // left out because it reads too slowly
  double bytes_per_s = 0;               // lately
};

struct RoomStats {
  std::string room;
  std::vector<SensorStats> sensors = {};
  std::vector<ViewerStats> viewers = {};
  std::uint64_t sets = 0;             // closed
  std::uint64_t incomplete_sets = 0;  // without a frame of a sensor that was online
  std::uint64_t dropped_sets = 0;     // left out for slow viewers, over all that were ever here
  double set_skew_s = 0;              // first to last capture in the newest set
};

/// First to last capture of a set; of a sensor that catches up only the newest frame counts.
[[nodiscard]] nanoseconds capture_skew(const FrameSet& set);
[[nodiscard]] std::size_t sensor_count(const FrameSet& set);

/// A frame has arrived; a set has closed while so many sensors were online.
void count_frame(const wire::FrameHeader& header, std::size_t bytes, RoomTime now,
                 SensorStats& stats);
void count_set(const FrameSet& set, std::size_t online_sensors, RoomStats& stats);

}  // namespace roomcast::hub
