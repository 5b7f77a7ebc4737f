// SPDX-License-Identifier: Apache-2.0
// Kinect v2 through libfreenect2 0.2: depth 512 x 424 and colour 1920 x 1080 at 30 frames/s, with
// the calibration in the camera's memory. The camera's pictures are mirrored; this backend mirrors
// them back, and the calibration with them. Not run on hardware yet. Places: a position or a serial
// number.
#pragma once

#include <memory>

#include "roomcast/source/camera/camera.h"

namespace roomcast::source {

[[nodiscard]] std::unique_ptr<CameraBackend> freenect2_backend();

}  // namespace roomcast::source
