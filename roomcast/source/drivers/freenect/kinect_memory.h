// SPDX-License-Identifier: Apache-2.0
// What a Kinect v1 remembers of its own making, read through libfreenect. Single-threaded.
#pragma once

#include <optional>

#include <libfreenect.h>

#include "roomcast/source/drivers/freenect/kinect_calibration.h"

namespace roomcast::source {

struct KinectMemory {
  KinectZeroPlane plane;
  SensorCalibration cameras;
};

/// Nothing where the library does not tell, or what it tells is no calibration.
[[nodiscard]] std::optional<KinectMemory> read_kinect_memory(freenect_device* device);

}  // namespace roomcast::source
