// SPDX-License-Identifier: Apache-2.0
// Converts calibrations and transforms between geometry's types and the wire's messages. The only
// unit that depends on both.
#pragma once

#include <google/protobuf/repeated_field.h>

#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::client {

[[nodiscard]] wire::pb::Calibration message_from_calibration(const SensorCalibration& calibration);

/// kMalformed: the message's numbers are not a valid camera or transform.
[[nodiscard]] Result<SensorCalibration> calibration_from_message(
    const wire::pb::Calibration& message);

void write_transform(const RigidTransform& transform,
                     google::protobuf::RepeatedField<double>& row_major);
/// kMalformed unless these are the 16 numbers of a rigid transform.
[[nodiscard]] Result<RigidTransform> read_transform(
    const google::protobuf::RepeatedField<double>& row_major);

}  // namespace roomcast::client
