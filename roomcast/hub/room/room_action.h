// SPDX-License-Identifier: Apache-2.0
// RoomAction: an effect that a Room requests. The room itself uses no socket and no clock; its
// driver (RoomRunner) carries out the actions in order.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "roomcast/core/ids.h"
#include "roomcast/hub/room/frame_set.h"
#include "roomcast/hub/room/known_sensor.h"
#include "roomcast/hub/visibility/detail.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

struct SendControl {
  std::vector<ConnectionId> to;
  wire::pb::Control message;
};

/// To all viewers that were accepted before this action.
struct SendSet {
  FrameSetPtr set;
};

/// An audio packet for these listeners.
struct SendAudio {
  std::vector<ConnectionId> to;
  ViewerId speaker;
  net::FramedMessagePtr packet;
};

/// The viewer gets the sensors' frames in these details from now on.
struct SetDetails {
  ConnectionId viewer;
  SensorDetails details;
};

/// The sensor has started again. Frames that viewers already have are no reference for its next
/// ones.
struct RestartSensor {
  SensorId sensor;
};

/// kHub: a viewer that relays the room to viewers of its own. kPlayer: a viewer that plays a
/// recording and gets no frames. kModeler gets key frames only.
enum class Role { kSensor, kViewer, kHub, kPlayer, kAligner, kModeler };

/// The connection was accepted in this role. From now on a sensor may send frames, and a viewer
/// gets them.
struct AcceptConnection {
  ConnectionId connection;
  Role role = Role::kViewer;
};

/// The room has removed this connection. Send it the reason and close it.
struct Disconnect {
  ConnectionId connection;
  wire::pb::ErrorCode code = wire::pb::ERROR_UNSPECIFIED;
  std::string sentence;
};

/// Save these sensors, so that the hub knows them after a restart.
struct SaveSensors {
  std::vector<KnownSensor> sensors;
};

/// Save these marks and delete those, so that the room has the same ones after a restart of the
/// hub.
struct SaveMarks {
  std::vector<wire::pb::Mark> added = {};
  std::vector<std::uint32_t> removed = {};  // IDs
};

using RoomAction = std::variant<SendControl, SendSet, SendAudio, SetDetails, RestartSensor,
                                AcceptConnection, Disconnect, SaveSensors, SaveMarks>;
using RoomActions = std::vector<RoomAction>;

}  // namespace roomcast::hub
