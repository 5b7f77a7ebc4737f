// SPDX-License-Identifier: Apache-2.0
// A recorded sensor in a folder: its cameras and the list of its frames, without pictures. Times
// are nanoseconds: `device_time` as stamped, `true_time` with the sensor's clock offset removed.
// Thread-safe (no state).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/result.h"
#include "roomcast/io/camera_json.h"
#include "roomcast/source/frame_source.h"

namespace roomcast::recording {

/// Timestamps from the year 2000 on are times of the day, since 1970-01-01 UTC; earlier ones count
/// from something else.
inline constexpr nanoseconds kEarliestUtc = std::chrono::seconds(946'684'800);

struct RecordedFrame {
  std::uint64_t index = 0;  // frame number: that of the file's name, else the position in the list
  nanoseconds device_time{};
  nanoseconds true_time{};
  std::filesystem::path depth;
  std::filesystem::path color;  // empty without colour
};

struct Recording {
  source::SensorDescription description;
  io::RecordedCamera camera;          // of a rig: with the depth scale that rig.json gives
  std::vector<RecordedFrame> frames;  // at least one, in order of time
  nanoseconds start{};                // true time at which playback begins
  nanoseconds loop_duration{};        // playback restarts after this; longer than the frames last
  // As in rig.json; 0: unknown.
  double expected_error_mm = 0, scale_error = 0;
};

/// Reads one sensor of a rig folder. All sensors of a rig get the same `start` and `loop_duration`.
/// kNotFound for a sensor that is not in the rig (the message lists those that are), and for
/// missing files; kMalformed naming file and field or line.
[[nodiscard]] Result<Recording> read_rig_recording(const std::filesystem::path& directory,
                                                   const std::string& sensor);

/// The names of a rig's sensors, in the order of rig.json: "s0", "s1"... Errors of read_rig_json.
[[nodiscard]] Result<std::vector<std::string>> rig_sensor_names(
    const std::filesystem::path& directory);

/// Reads a folder in the layout of the TUM RGB-D benchmark, with camera.json. Errors as above. The
/// colour of a depth picture is the nearest in time within half a frame, unless associations.txt
/// gives it.
[[nodiscard]] Result<Recording> read_tum_recording(const std::filesystem::path& directory);

}  // namespace roomcast::recording
