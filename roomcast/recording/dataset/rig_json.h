// SPDX-License-Identifier: Apache-2.0
// Reads and writes rig.json, which describes a recording of several sensors.
//
//   {"version": 1, "fps": 30,
//    "sensors": [{"id": "s0", "path": "s0", "world_from_depth": [16 numbers, row-major] or null,
//                 "clock_offset_s": 0, "rate_ppm": 0, "drop": [23], "depth_scale": 1,
//                 "expected_error_mm": 0}, ...],
//    "scale_error": 0}
//
// Each sensor's folder `path` (inside the rig's) contains camera.json, depth.txt, rgb.txt,
// depth/*.png and rgb/*.jpg, the lists in the layout of the TUM RGB-D benchmark: a timestamp in
// seconds and a file per line.
//   clock_offset_s  a sensor's timestamps minus true time
//   rate_ppm        how much faster than `fps` its frames come; its timestamps include that
//   drop            numbers of lost frames; these have no files and no lines
//   depth_scale     true depth divided by what camera.json makes of the depth pictures
//   expected_error_mm  of an estimated pose, one standard deviation 2.5 m ahead; 0: unknown
//   scale_error     by which all distances may be off alike, one standard deviation; 0: unknown
// Metres, seconds. Thread-safe (no state).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::recording {

inline constexpr std::size_t kMaxRigSensors = 32;
inline constexpr std::size_t kMaxSensorNameBytes = 64;
inline constexpr double kMaxFps = 240;

struct RigSensorEntry {
  std::string id;
  std::filesystem::path path;  // relative to the rig
  std::optional<RigidTransform> world_from_depth;
  double clock_offset_s = 0;
  double rate_ppm = 0;
  std::vector<std::uint64_t> drop;
  double depth_scale = 1;
  double expected_error_mm = 0;
};

struct RigDescription {
  double fps = 30;
  std::string source;  // name of the program that made it, for display
  std::vector<RigSensorEntry> sensors;
  double scale_error = 0;
};

/// kNotFound if the file is missing; kUnsupported for another version; kMalformed, naming file and
/// field, for any other deviation from the above, duplicate IDs, and paths that leave the rig.
[[nodiscard]] Result<RigDescription> read_rig_json(const std::filesystem::path& path);

[[nodiscard]] std::string rig_json_text(const RigDescription& rig);

/// True if a sensor may have this name: 1..64 bytes without control characters.
[[nodiscard]] bool is_sensor_name(const std::string& name);

/// True if a sensor may have this depth scale: 0.5 to 2.
[[nodiscard]] bool is_depth_scale(double scale);

/// True if a relative path stays inside the folder that it starts from.
[[nodiscard]] bool stays_inside(const std::filesystem::path& path);

}  // namespace roomcast::recording
