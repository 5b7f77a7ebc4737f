// SPDX-License-Identifier: Apache-2.0
// Converts poses between geometry's types and the wire's messages. Thread-safe (no state).
#pragma once

#include <google/protobuf/repeated_field.h>

#include "roomcast/core/result.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/geometry/sensor_pose.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::wire {

void write_transform(const RigidTransform& transform,
                     google::protobuf::RepeatedField<double>& row_major);

/// kMalformed unless these are the 16 numbers of a rigid transform. Its rotation becomes exactly
/// orthonormal, which may change last bits.
[[nodiscard]] Result<RigidTransform> read_transform(
    const google::protobuf::RepeatedField<double>& row_major);

/// The transform with exactly these numbers, of a message that decode_control has checked: a hub
/// forwards poses as they are.
[[nodiscard]] RigidTransform exact_transform(
    const google::protobuf::RepeatedField<double>& row_major);

/// kMalformed unless the entry has the 16 numbers of a rigid transform.
[[nodiscard]] Result<SensorPose> read_pose(const pb::SensorEntry& entry);
void write_pose(const SensorPose& pose, pb::SensorEntry& entry);

/// An aligner's result, which decode_control has checked, with exactly its numbers. It has no
/// source if the sensor could not be placed.
[[nodiscard]] SensorPose read_pose(const pb::SensorPlacement& placement);
/// Cuts a note that is too long for a message.
void write_pose(const SensorPose& pose, pb::SensorPlacement& placement);

}  // namespace roomcast::wire
