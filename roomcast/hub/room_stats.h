// SPDX-License-Identifier: Apache-2.0
// RoomStats: how a room is doing, for whoever runs the hub: `/metrics`, in the text format of
// Prometheus (version 0.0.4).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/hub/frame_set.h"

namespace roomcast::hub {

struct SensorStats {
  std::string name;
  bool online = false;
  std::uint64_t frames = 0;
  std::uint64_t bytes = 0;
  std::optional<double> clock_error_s = {};  // the sensor's own bound, of its newest frame
  double delay_s = 0;                        // capture to arrival, of its newest frame
};

struct RoomStats {
  std::string room;
  std::vector<SensorStats> sensors = {};
  std::size_t viewers = 0;
  std::uint64_t sets = 0;             // closed
  std::uint64_t incomplete_sets = 0;  // without a frame of a sensor that was online
  double set_skew_s = 0;              // first to last capture in the newest set
};

/// First to last capture of a set; of a sensor that catches up only the newest frame counts.
[[nodiscard]] nanoseconds capture_skew(const FrameSet& set);
[[nodiscard]] std::size_t sensor_count(const FrameSet& set);

/// A frame has arrived; a set has closed while so many sensors were online.
void count_frame(const wire::FrameHeader& header, std::size_t bytes, RoomTime now,
                 SensorStats& stats);
void count_set(const FrameSet& set, std::size_t online_sensors, RoomStats& stats);

/// `dropped_sets`: that were left out for slow viewers, over all viewers.
[[nodiscard]] std::string metrics_text(const RoomStats& stats, std::uint64_t dropped_sets);

}  // namespace roomcast::hub
