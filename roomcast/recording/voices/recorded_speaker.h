// SPDX-License-Identifier: Apache-2.0
// Who spoke in a recording, by its rosters: a person, or a sensor's microphone. No state.
#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "roomcast/core/clock.h"
#include "roomcast/core/ids.h"
#include "roomcast/recording/room/room_recording.h"

namespace roomcast::recording {

/// As in the roster of that time, or, where it was not there yet, of a later one. "viewer N" for
/// somebody without a name. `log_time` as in RecordedRoster.
[[nodiscard]] std::string recorded_name(const RoomRecording& recording, ViewerId speaker,
                                        nanoseconds log_time);

/// Where a sensor stood, metres, world frame; nothing: no roster has its pose.
[[nodiscard]] std::optional<Eigen::Vector3d> recorded_place(const RoomRecording& recording,
                                                            SensorId sensor, nanoseconds log_time);

}  // namespace roomcast::recording
