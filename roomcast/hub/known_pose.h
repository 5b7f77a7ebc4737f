// SPDX-License-Identifier: Apache-2.0
// Where a sensor was found to stand. Plain data.
#pragma once

#include <string>

#include "roomcast/hub/matrix4.h"

namespace roomcast::hub {

struct KnownPose {
  std::string sensor;  // its name
  Matrix4 world_from_depth{};
  float expected_error_mm = 0;
};

}  // namespace roomcast::hub
