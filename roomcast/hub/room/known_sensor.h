// SPDX-License-Identifier: Apache-2.0
// What a hub knows of a sensor beyond its own life. Plain data.
#pragma once

#include <optional>
#include <string>

#include "roomcast/core/ids.h"
#include "roomcast/hub/config/matrix4.h"

namespace roomcast::hub {

/// Where alignment found that a sensor stands.
struct KnownPose {
  Matrix4 world_from_depth{};
  float expected_error_mm = 0;
};

struct KnownSensor {
  std::string name;  // its identity in the room
  SensorId id;
  std::optional<KnownPose> pose = {};  // nothing: never found, or the sensor says it itself
};

}  // namespace roomcast::hub
