// SPDX-License-Identifier: Apache-2.0
// Kinect v1 (Kinect for Xbox 360, Kinect for Windows) through libfreenect 0.5 or newer: raw 11-bit
// depth and full colour, 640 x 480 at 30 frames/s, and the calibration in the camera's memory.
// Places: "0", "1"... in USB order, or a serial number.
#pragma once

#include <memory>

#include "roomcast/source/camera/camera.h"

namespace roomcast::source {

[[nodiscard]] std::unique_ptr<CameraBackend> freenect_backend();

}  // namespace roomcast::source
