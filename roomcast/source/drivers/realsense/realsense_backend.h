// SPDX-License-Identifier: Apache-2.0
// Intel RealSense cameras through librealsense 2 (2.50 or newer), and .bag files recorded with it:
// depth and colour, 640 x 480 at 30 frames/s, with the manufacturer's calibration. Not run on
// hardware yet. Places: a position, a serial number, or the path of a .bag file.
#pragma once

#include <memory>

#include "roomcast/source/camera/camera.h"

namespace roomcast::source {

[[nodiscard]] std::unique_ptr<CameraBackend> realsense_backend();

}  // namespace roomcast::source
