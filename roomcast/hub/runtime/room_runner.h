// SPDX-License-Identifier: Apache-2.0
// RoomRunner: one room of a running hub: its state, its connections and its timer. It takes the
// room's events and carries out the actions that the room returns. Threading: the rooms' thread.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/ids.h"
#include "roomcast/hub/room/room.h"
#include "roomcast/hub/runtime/backplane.h"
#include "roomcast/hub/runtime/connection.h"
#include "roomcast/hub/runtime/shard.h"
#include "roomcast/hub/store/store_worker.h"
#include "roomcast/net/timer.h"

namespace roomcast::hub {

class RoomRunner : public std::enable_shared_from_this<RoomRunner> {
 public:
  /// The parts of the hub that a room needs; they outlive it.
  struct Context {
    boost::asio::io_context& io;
    std::span<const std::unique_ptr<Shard>> shards;
    StoreWorker& store_worker;
    Backplane* backplane;  // null: there are no other hubs
    const Clock& clock;
    std::function<void(const std::string&)> warn;
    std::function<void(const Disconnect&)> on_removed;  // the room has removed this connection
    /// Sensors were placed, or lost their place.
    std::function<void(const std::string& room, const std::vector<KnownSensor>&)> on_placed = {};
  };

  RoomRunner(RoomId id, Room room, Context context);

  // Events; see Room.

  /// A client was admitted with the permissions in `entry`.
  void join(const ConnectionPtr& client, const wire::pb::Join& join, const Entry& entry);
  /// A connection has closed.
  void leave(ConnectionId from);
  void control(ConnectionId from, const wire::pb::Control& message);
  /// A frame of a sensor that is connected to this hub. If the room accepts it, the other hubs get
  /// it, too.
  void frame(ConnectionId from, const wire::FrameHeader& header, net::MessageBuffer message);
  /// An audio packet of a viewer.
  void audio(ConnectionId from, const wire::AudioHeader& header, net::MessageBuffer message);
  /// As Room::mute.
  void mute(ViewerId viewer, bool muted) { apply(room_.mute(viewer, muted, now())); }
  /// Frames of sensors at other hubs that arrived together. Their messages are moved from.
  void frames(std::span<IncomingFrame> together);
  /// Frames of these sensors were dropped for a viewer, or for viewers of another hub.
  void request_keys(const std::vector<SensorId>& sensors);
  /// As Room::small_needed.
  void need_small(ConnectionId viewer, const SmallNeeds& needs);
  void forget_sensor(const std::string& sensor);

  /// Whether other hubs have viewers for the sensors of this one.
  void watch_elsewhere(bool is_watched);

  /// As Room::change.
  void change(RoomSettings settings) { apply(room_.change(std::move(settings), now())); }
  /// Sends a message of the hub to a client; no effect if it has left.
  void send(ConnectionId to, const wire::pb::Control& message) const;
  /// Removes a client from the room and disconnects it; no effect if it has left.
  void disconnect_client(ConnectionId client, wire::pb::ErrorCode code,
                         const std::string& sentence);
  /// Disconnects all clients, stops the timer and removes the room from the shards.
  void close(const std::string& sentence);

  [[nodiscard]] RoomId id() const { return id_; }
  [[nodiscard]] const std::string& name() const { return room_.name(); }
  [[nodiscard]] const RoomSettings& settings() const { return room_.settings(); }
  [[nodiscard]] RoomStats stats() const { return room_.stats(); }

 private:
  [[nodiscard]] RoomTime now() const { return RoomTime(context_.clock.now().time_since_epoch()); }
  [[nodiscard]] ConnectionPtr find(ConnectionId connection) const;
  void apply(const RoomActions& actions);
  void apply(const SendControl& action);
  void apply(const SendSet& action);
  void apply(const SendAudio& action);
  void apply(const SetDetails& action);
  void apply(const RestartSensor& action);
  void apply(const AcceptConnection& action);
  void apply(const Disconnect& action);
  void apply(const SaveSensors& action);
  void apply(const SaveMarks& action);
  void notify_backplane();
  void schedule_tick();

  const RoomId id_;
  Room room_;
  const Context context_;
  std::unordered_map<ConnectionId, ConnectionPtr> connections_;
  net::Timer timer_;
  std::optional<RoomTime> armed_for_;  // the time for which timer_ is set
  bool is_watched_ = false;            // as last reported to the backplane
  std::uint64_t closed_sets_ = 0;      // as last reported to the backplane
};

}  // namespace roomcast::hub
