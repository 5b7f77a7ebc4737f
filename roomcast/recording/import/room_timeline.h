// SPDX-License-Identifier: Apache-2.0
// Puts the clocks of several recorded sensors on one timeline, so that recordings of one event play
// as one room. Device times of cameras that a sync cable joined are of one clock; others are joined
// by the time of day that their files state, or by the clock of the recording that they are all in;
// if there is none, their first frames are put at one instant. Thread-safe (no state).
#pragma once

#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/recording/import/sensor_file.h"

namespace roomcast::recording {

enum class JoiningClock { kAutomatic, kCable, kTimeOfDay, kRecording, kStart };

struct RoomTimeline {
  JoiningClock clock = JoiningClock::kStart;  // what joined them, never kAutomatic
  std::string explanation;                    // of `clock`, as the end of a sentence
  std::vector<nanoseconds> clock_offsets;     // of each sensor: device time minus room time
  nanoseconds start{};                        // room time of the earliest frame
  nanoseconds loop_duration{};  // a whole number of frame periods, longer than all frames
  double fps = 30;              // of the fastest sensor
};

/// `sensors`: at least one. kInvalidArgument: `wanted` needs what a file does not state, or the
/// recordings do not overlap in time.
[[nodiscard]] Result<RoomTimeline> join_clocks(const std::vector<const SensorFileInfo*>& sensors,
                                               JoiningClock wanted = JoiningClock::kAutomatic);

}  // namespace roomcast::recording
