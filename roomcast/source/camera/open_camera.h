// SPDX-License-Identifier: Apache-2.0
// Opens a camera of one kind from a user's place ("0", a serial number, a file), and replaces a
// library's "error -3" by the actual reason. Thread-safe if the backend is.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/source/camera/camera.h"

namespace roomcast::source {

/// `place`: empty (the camera at position 0), a position in the list, a serial number, a place as
/// listed, or a file that this kind plays. kInvalidArgument: contradictory settings; kUnsupported:
/// settings that this kind of camera does not support; kNotFound: no such camera; kUnavailable: it
/// exists but cannot be opened.
[[nodiscard]] Result<std::unique_ptr<Camera>> open_camera(CameraBackend& backend,
                                                          const std::string& place,
                                                          const CameraSettings& settings);

/// Returns the camera at `place`. kNotFound, with the list of connected cameras.
[[nodiscard]] Result<CameraInfo> choose_camera(const std::vector<CameraInfo>& cameras,
                                               const std::string& kind, const std::string& place);

}  // namespace roomcast::source
