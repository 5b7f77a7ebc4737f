// SPDX-License-Identifier: Apache-2.0
// KnownRoom: what a hub knows of a room from before its start. Plain data.
#pragma once

#include <vector>

#include "roomcast/hub/room/known_sensor.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

struct KnownRoom {
  std::vector<KnownSensor> sensors = {};
  std::vector<wire::pb::Mark> marks = {};
};

}  // namespace roomcast::hub
