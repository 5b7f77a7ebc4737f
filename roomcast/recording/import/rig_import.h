// SPDX-License-Identifier: Apache-2.0
// Writes recordings of other programs as one rig (docs/spec/rig.md): depth as it was recorded, in
// millimetres; colour that was recorded as JPEG byte for byte, other colour as JPEG. Frames are
// written in order of time. Single-threaded.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/recording/import/room_timeline.h"
#include "roomcast/recording/import/sensor_file.h"

namespace roomcast::recording {

struct ImportedSensor {
  std::string name;
  std::uint64_t frames = 0;       // written
  std::uint64_t colors = 0;       // of these, with colour
  std::uint64_t damaged = 0;      // left out, or written without their colour
  std::string first_damage = {};  // sentence
};

struct RigImportOptions {
  std::vector<std::string> names;  // of the sensors, unique
  std::string source = {};         // program and formats, for display in rig.json
  int jpeg_quality = 90;
  /// Called after each frame with frames done, and frames in all.
  std::function<void(std::uint64_t, std::uint64_t)> progress = {};
};

/// `directory` must be empty or absent. Errors of RigWriter; kClosed when `stop` was requested: the
/// rig then ends there and can be played.
[[nodiscard]] Result<std::vector<ImportedSensor>> import_rig(
    const std::filesystem::path& directory, const std::vector<std::unique_ptr<SensorFile>>& sensors,
    const RoomTimeline& timeline, const RigImportOptions& options, std::stop_token stop);

}  // namespace roomcast::recording
