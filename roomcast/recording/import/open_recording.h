// SPDX-License-Identifier: Apache-2.0
// Opens recordings of other programs, by the kind that a SPEC names or by their content. Formats
// are listed in docs/guides/recordings.md. Thread-safe (no state).
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/recording/import/sensor_file.h"

namespace roomcast::recording {

using SensorFiles = std::vector<std::unique_ptr<SensorFile>>;

/// "mkv", "bag", ...: the kinds of open_recording.
[[nodiscard]] bool is_import_kind(std::string_view kind);

/// The kind of a file by its content; empty if no format is recognised.
[[nodiscard]] std::string_view import_kind_of(const std::filesystem::path& file);

/// All sensors of a recording. kNotFound; kMalformed, kUnsupported, kTooLarge with file and
/// problem; kInvalidArgument for an unknown kind.
[[nodiscard]] Result<SensorFiles> open_recording(std::string_view kind,
                                                 const std::filesystem::path& path);

/// One sensor of it: the one of that name, or the only one if `sensor` is empty. kNotFound for
/// another name, or without a name if there are several (the message lists them).
[[nodiscard]] Result<std::unique_ptr<SensorFile>> open_sensor(std::string_view kind,
                                                              const std::filesystem::path& path,
                                                              const std::string& sensor);

/// All sensors in a file or folder whose kind its content tells; of a folder that is no recording
/// itself, those of all recordings in it, by name. Names are unique. Errors as above; kUnsupported
/// if no format is recognised, or if it is roomcast's own.
[[nodiscard]] Result<SensorFiles> open_any(const std::filesystem::path& path);

}  // namespace roomcast::recording
