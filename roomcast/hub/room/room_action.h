// SPDX-License-Identifier: Apache-2.0
// What a Room wants done. The room itself touches no socket and no clock; whoever drives it carries
// these out in order.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "roomcast/core/ids.h"
#include "roomcast/hub/room/frame_set.h"
#include "roomcast/hub/room/known_sensor.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

struct SendControl {
  std::vector<ConnectionId> to;
  wire::pb::Control message;
};

/// To all viewers that were accepted before.
struct SendSet {
  FrameSetPtr set;
};

/// The sensor starts anew: what viewers were sent of it is nothing to build on.
struct RestartSensor {
  SensorId sensor;
};

/// kHub: a viewer that serves the room on.
enum class Role { kSensor, kViewer, kHub, kAligner };

/// This connection was accepted. Frames may come from sensors, and go to viewers.
struct AcceptConnection {
  ConnectionId connection;
  Role role = Role::kViewer;
};

/// The room knows this connection no more. Tell it why and close it.
struct Disconnect {
  ConnectionId connection;
  wire::pb::ErrorCode code = wire::pb::ERROR_UNSPECIFIED;
  std::string sentence;
};

/// To be known when the hub starts again.
struct KeepSensors {
  std::vector<KnownSensor> sensors;
};

using RoomAction =
    std::variant<SendControl, SendSet, RestartSensor, AcceptConnection, Disconnect, KeepSensors>;
using RoomActions = std::vector<RoomAction>;

}  // namespace roomcast::hub
