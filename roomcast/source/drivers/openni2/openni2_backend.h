// SPDX-License-Identifier: Apache-2.0
// Cameras through OpenNI 2.2 (Asus Xtion, PrimeSense Carmine, Orbbec Astra, any other with a driver
// for it), and .oni files. Depth in millimetres. Depth is registered to colour by the device where
// it can, with its factory calibration. Places: a position, a serial number, a URI of OpenNI, or
// the path of a .oni file.
#pragma once

#include <memory>

#include "roomcast/source/camera/camera.h"

namespace roomcast::source {

[[nodiscard]] std::unique_ptr<CameraBackend> openni2_backend();

}  // namespace roomcast::source
