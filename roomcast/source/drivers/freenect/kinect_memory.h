// SPDX-License-Identifier: Apache-2.0
// Reads the factory calibration of a Kinect v1 through libfreenect. Single-threaded.
#pragma once

#include <optional>

#include <libfreenect.h>

#include "roomcast/source/drivers/freenect/kinect_calibration.h"

namespace roomcast::source {

struct KinectMemory {
  KinectZeroPlane plane;
  SensorCalibration cameras;
};

/// Nothing if the library does not provide it, or it is no valid calibration.
[[nodiscard]] std::optional<KinectMemory> read_kinect_memory(freenect_device* device);

}  // namespace roomcast::source
