// SPDX-License-Identifier: Apache-2.0
// Converts librealsense's calibration. Metres, pixels. Thread-safe (no state).
#pragma once

#include <librealsense2/h/rs_sensor.h>
#include <librealsense2/h/rs_types.h>

#include "roomcast/geometry/camera_model.h"

namespace roomcast::source {

[[nodiscard]] SensorCalibration realsense_calibration(const rs2_intrinsics& depth,
                                                      const rs2_intrinsics& color,
                                                      const rs2_extrinsics& color_from_depth);

}  // namespace roomcast::source
