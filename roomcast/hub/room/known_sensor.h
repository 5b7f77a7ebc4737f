// SPDX-License-Identifier: Apache-2.0
// KnownSensor: the data about a sensor that a hub keeps across restarts. Plain data.
#pragma once

#include <optional>
#include <string>

#include "roomcast/core/ids.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::hub {

/// The pose of a sensor that alignment estimated.
struct KnownPose {
  RigidTransform world_from_depth;
  float expected_error_mm = 0;
};

struct KnownSensor {
  std::string name;  // its identity in the room
  SensorId id;
  std::optional<KnownPose> pose = {};  // nothing: never estimated, or supplied by the sensor
};

}  // namespace roomcast::hub
