// SPDX-License-Identifier: Apache-2.0
// MirroredSensors: sensors of another hub's room in a room of this hub, as if each were connected
// here: who is there and its frames come in, what the room here asks of a sensor goes out. Frames
// keep their bytes but for the sensor's id, the time (of this hub's clock) and its error. A pose
// that somebody gave is given on; what alignment found is left to whoever owns this. Pure but for
// whom it tells. Threading: the rooms' thread.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "roomcast/client/room/clock_estimate.h"
#include "roomcast/hub/runtime/backplane.h"
#include "roomcast/net/message_buffer.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub::federation {

/// A sensor that is online at the other hub.
struct SensorThere {
  wire::pb::SensorEntry entry;
  /// Of the token that it showed there, where the other hub says so; else it is as good as ours.
  std::optional<std::string> token_id = {};
};

struct MirroredSensor {
  SensorThere there;
  ConnectionId connection;          // here
  std::optional<SensorId> id = {};  // here, once it was welcomed
};

class MirroredSensors {
 public:
  using NewConnection = std::function<ConnectionId()>;

  /// `here` is told; `token` lets anybody into its room, and it outlives this. `other_hub`: tells
  /// that hub from others whose sensors are in the room here, not 0.
  MirroredSensors(std::uint64_t other_hub, std::string room, std::string token,
                  hub::BackplaneEvents& here, NewConnection new_connection);

  // From the other hub.
  /// All that are online there; who was and is not any more is gone here too.
  void follow(const std::vector<SensorThere>& online);
  void clock_is(const client::ClockEstimate& estimate) { clock_ = estimate; }
  /// Dropped while the clock, or the sensor's id here, are not known; what is no frame, too.
  void frame(net::MessageBuffer message);
  /// Nothing more came with these frames: they go on to the room, together.
  void pass_on();
  /// What the sensor with this id there has said.
  void say(std::uint32_t id_there, const wire::pb::Control& message);
  /// Until it comes back all sensors are gone.
  void other_hub_is_gone();

  // From the room here.
  /// To one of our connections. The message that the other hub should get, if any.
  std::optional<wire::pb::Control> said(ConnectionId to, const wire::pb::Control& message);
  /// It was sent away. True: it was one of ours. Back when it is followed again.
  bool let_go(ConnectionId connection);

  /// By their ids there.
  [[nodiscard]] const std::map<std::uint32_t, MirroredSensor>& all() const { return sensors_; }
  /// Is it in the room here, through us?
  [[nodiscard]] bool has(std::string_view name) const;
  /// A time of the other hub's clock in this one's. Nothing while that is not known.
  [[nodiscard]] std::optional<RoomTime> time_here(RoomTime there) const;

 private:
  using Sensors = std::map<std::uint32_t, MirroredSensor>;

  void follow(const SensorThere& sensor);
  void join(const SensorThere& sensor);
  Sensors::iterator leave(Sensors::iterator sensor);
  [[nodiscard]] Sensors::iterator find(ConnectionId connection);

  const std::uint64_t other_hub_;
  const std::string room_, token_;
  hub::BackplaneEvents& here_;
  const NewConnection new_connection_;
  Sensors sensors_;
  std::optional<client::ClockEstimate> clock_;
  std::vector<hub::IncomingFrame> came_;  // and were not passed on yet
};

/// What alignment knows of it, as an aligner's word on sensor `here`; the newest there is.
[[nodiscard]] wire::pb::SensorPlacement placement_of(const wire::pb::SensorEntry& entry,
                                                     SensorId here);

}  // namespace roomcast::hub::federation
