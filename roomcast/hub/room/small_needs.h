// SPDX-License-Identifier: Apache-2.0
// SmallNeeds: what a viewer with a slow line needs of the sensors' small renditions, and what it
// does without.
#pragma once

#include <vector>

#include "roomcast/core/ids.h"

namespace roomcast::hub {

struct SmallNeeds {
  std::vector<SensorId> wanted = {};     // of these sensors it should get them
  std::vector<SensorId> held_back = {};  // of these it gets key frames only
  std::vector<SensorId> keys = {};       // of these it needs a key frame of their small rendition
};

}  // namespace roomcast::hub
