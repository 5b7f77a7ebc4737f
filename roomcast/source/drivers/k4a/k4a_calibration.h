// SPDX-License-Identifier: Apache-2.0
// Converts libk4a's calibration. Metres, pixels. Thread-safe (no state).
#pragma once

#include <k4a/k4atypes.h>

#include "roomcast/geometry/camera_model.h"

namespace roomcast::source {

[[nodiscard]] SensorCalibration k4a_calibration(const k4a_calibration_t& from);

}  // namespace roomcast::source
