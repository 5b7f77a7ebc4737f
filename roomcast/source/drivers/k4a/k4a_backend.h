// SPDX-License-Identifier: Apache-2.0
// Azure Kinect through Microsoft's libk4a 1.4, and Orbbec Femto cameras through Orbbec's library
// with the same interface: depth 640 x 576 (narrow field of view, unbinned) and colour 1280 x 720
// at 30 frames/s, with the manufacturer's calibration. Not run on hardware yet. Places: a position
// or a serial number.
#pragma once

#include <memory>

#include "roomcast/source/camera/camera.h"

namespace roomcast::source {

[[nodiscard]] std::unique_ptr<CameraBackend> k4a_backend();

}  // namespace roomcast::source
