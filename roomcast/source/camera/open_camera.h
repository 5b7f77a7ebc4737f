// SPDX-License-Identifier: Apache-2.0
// From what a user says ("0", a serial number, a file) to an open camera of one kind, and from a
// library's "error -3" to what is in the way. Thread-safe as far as the backend is.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/source/camera/camera.h"

namespace roomcast::source {

/// `place`: empty (the camera at position 0), a position in the list, a serial number, a place as
/// listed, or a file that this kind plays. kInvalidArgument: settings that contradict each other;
/// kUnsupported: settings that this kind of camera does not know; kNotFound: no such camera;
/// kUnavailable: it is there but cannot be opened.
[[nodiscard]] Result<std::unique_ptr<Camera>> open_camera(CameraBackend& backend,
                                                          const std::string& place,
                                                          const CameraSettings& settings);

/// The one that `place` means. kNotFound with what there is.
[[nodiscard]] Result<CameraInfo> choose_camera(const std::vector<CameraInfo>& cameras,
                                               const std::string& kind, const std::string& place);

}  // namespace roomcast::source
