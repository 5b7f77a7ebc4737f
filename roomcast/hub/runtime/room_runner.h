// SPDX-License-Identifier: Apache-2.0
// RoomRunner: one room of a running hub: its state and its timer. Carries out the room's actions.
// Threading: the rooms' thread.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <boost/asio/steady_timer.hpp>

#include "roomcast/core/clock.h"
#include "roomcast/core/ids.h"
#include "roomcast/hub/room/room.h"
#include "roomcast/hub/runtime/backplane.h"
#include "roomcast/hub/runtime/shard.h"
#include "roomcast/hub/store/store_worker.h"

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
    std::function<void(const std::string&)> complain;
    std::function<void(const Disconnect&)> on_removed;  // the room has removed this connection
  };

  RoomRunner(RoomId id, Room room, Context around);

  [[nodiscard]] Room& room() { return room_; }
  [[nodiscard]] const Room& room() const { return room_; }
  [[nodiscard]] RoomId id() const { return id_; }
  [[nodiscard]] RoomTime now() const { return RoomTime(context_.clock.now().time_since_epoch()); }

  /// Carries out the actions that an event of the room returned.
  void apply(RoomActions actions);

  /// Removes a client that is in the room, and disconnects it.
  void disconnect_client(ConnectionId connection, wire::pb::ErrorCode code,
                         const std::string& sentence);

  /// Stops the timer and removes the room from the shards. All clients must have left.
  void close();

 private:
  void apply(const SendControl& action);
  void apply(const SendSet& action);
  void apply(const RestartSensor& action);
  void apply(const AcceptConnection& action);
  void apply(const Disconnect& action);
  void apply(const SaveSensors& action);
  void notify_backplane();
  void schedule_tick();
  [[nodiscard]] Shard& shard_of(ConnectionId connection) const {
    return *context_.shards[Shard::of(connection, context_.shards.size())];
  }

  const RoomId id_;
  Room room_;
  const Context context_;
  boost::asio::steady_timer timer_;
  std::optional<RoomTime> armed_for_;  // the time for which timer_ is set
  bool is_watched_ = false;            // as last reported to the backplane
  std::uint64_t closed_sets_ = 0;      // as last reported to the backplane
};

}  // namespace roomcast::hub
