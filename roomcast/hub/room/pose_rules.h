// SPDX-License-Identifier: Apache-2.0
// How the messages of sensors and aligners change a sensor's pose. A pose supplied by the sensor is
// authoritative. An estimated pose is replaced by later estimates. A sensor with neither gets a
// placeholder, so that viewers can show it. After the sensor was moved no pose is valid until one
// is estimated from what it has seen since. A sensor that was offline may have been moved
// unnoticed, so its estimated pose is then unverified. docs/spec/wire.md §3, "Where sensors stand".
#pragma once

#include <cstddef>
#include <span>

#include "roomcast/geometry/sensor_pose.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

/// The placeholder for the pose of the `nth` unplaced sensor: next to the room, well outside the
/// area of the placed sensors.
[[nodiscard]] RigidTransform placeholder_pose(std::size_t nth,
                                              std::span<const RigidTransform> placed = {});

/// Takes the pose that the sensor supplies in its Join, if any.
void take_given(const wire::pb::SensorRole& role, SensorPose& pose);

/// Takes an aligner's result. True: the estimated pose was set or withdrawn.
bool take_estimate(const wire::pb::SensorPlacement& found, SensorPose& pose);

/// The sensor was offline: an estimated pose becomes a stored one.
void doubt(SensorPose& pose);

/// A stored pose is confirmed.
void confirm(SensorPose& pose);

}  // namespace roomcast::hub
