// SPDX-License-Identifier: Apache-2.0
// MirroredSensors: sensors of another hub's room in a room of this hub, as if each were connected
// here. Their presence and frames are passed to the room here; the room's key requests are passed
// to the other hub. Frames keep their bytes except for the sensor ID, the capture time (converted
// to this hub's clock) and its error. Given poses are passed on; estimated poses are left to the
// owner of this object. Pure except for its calls to `here`. Threading: the rooms' thread.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomcast/client/room/clock_estimate.h"
#include "roomcast/hub/federation/mirror/backplane_connection.h"
#include "roomcast/hub/runtime/backplane.h"
#include "roomcast/net/message_buffer.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub::federation {

/// A sensor that is online at the other hub.
struct SensorThere {
  wire::pb::SensorEntry entry;
  /// Of the token used there, if the other hub reports it; nothing: the token of the mirrored join
  /// applies.
  std::optional<std::string> token_id = {};
};

struct MirroredSensor {
  SensorThere there;
  ConnectionId connection;          // in the room here
  std::optional<SensorId> id = {};  // in the room here, after its welcome
};

class MirroredSensors {
 public:
  /// `here` gets the events and must outlive this; `token` admits any client to its room.
  /// `other_hub`: distinguishes that hub from others whose sensors are in the room here; not 0.
  MirroredSensors(std::uint64_t other_hub, std::string room, std::string token,
                  hub::BackplaneEvents& here, NewConnection new_connection);

  // From the other hub.
  /// Sets the sensors online there; those no longer online leave the room here.
  void set_online(const std::vector<SensorThere>& online);
  void set_clock(const client::ClockEstimate& estimate) { clock_ = estimate; }
  /// Dropped while the clock offset or the sensor's ID here is unknown, or if it is not a valid
  /// frame.
  void frame(net::MessageBuffer message);
  /// Delivers the frames received so far to the room, together.
  void deliver_frames();
  /// Forwards a message of the sensor with this ID there to the room.
  void forward(std::uint32_t id_there, const wire::pb::Control& message);
  /// Removes all sensors until the hub returns.
  void on_hub_lost();

  // From the room here.
  /// A message to one of our connections. Returns the message to send to the other hub, if any.
  std::optional<wire::pb::Control> on_room_message(ConnectionId to,
                                                   const wire::pb::Control& message);
  /// The connection was removed from the room. True: it was one of ours. It rejoins with the next
  /// set_online().
  bool on_removed(ConnectionId connection);

  /// By their IDs there.
  [[nodiscard]] const std::map<std::uint32_t, MirroredSensor>& all() const { return sensors_; }
  /// Whether this sensor is in the room here through this object.
  [[nodiscard]] bool has(std::string_view name) const;
  /// Converts a time of the other hub's clock to this one's. Nothing while the offset is unknown.
  [[nodiscard]] std::optional<RoomTime> time_here(RoomTime there) const;

 private:
  using Sensors = std::map<std::uint32_t, MirroredSensor>;

  void update(const SensorThere& sensor);
  void join(const SensorThere& sensor);
  Sensors::iterator leave(Sensors::iterator sensor);
  [[nodiscard]] Sensors::iterator find(ConnectionId connection);

  const std::uint64_t other_hub_;
  const std::string room_, token_;
  hub::BackplaneEvents& here_;
  const NewConnection new_connection_;
  Sensors sensors_;
  std::optional<client::ClockEstimate> clock_;
  std::vector<hub::IncomingFrame> received_;  // not yet delivered
};

/// The estimated pose in `entry`, as an aligner's placement of sensor `here`.
[[nodiscard]] wire::pb::SensorPlacement placement_of(const wire::pb::SensorEntry& entry,
                                                     SensorId here);

}  // namespace roomcast::hub::federation
