// SPDX-License-Identifier: Apache-2.0
// KnownSensor: the data about a sensor that a hub keeps across restarts. Plain data.
#pragma once

#include <optional>
#include <string>

#include "roomcast/core/ids.h"
#include "roomcast/geometry/sensor_pose.h"

namespace roomcast::hub {

struct KnownSensor {
  std::string name;  // its identity in the room
  SensorId id;
  std::optional<SensorPose> pose = {};  // nothing: never estimated, or supplied by the sensor
};

}  // namespace roomcast::hub
