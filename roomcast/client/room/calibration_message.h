// SPDX-License-Identifier: Apache-2.0
// Converts calibrations between geometry's type and the wire's message.
#pragma once

#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::client {

[[nodiscard]] wire::pb::Calibration message_from_calibration(const SensorCalibration& calibration);

/// kMalformed: the message's numbers are not a valid camera or transform.
[[nodiscard]] Result<SensorCalibration> calibration_from_message(
    const wire::pb::Calibration& message);

}  // namespace roomcast::client
