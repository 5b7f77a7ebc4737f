// SPDX-License-Identifier: Apache-2.0
// RoomRunner: one room of a running hub: its state, its timer, and what carries out what it wants
// done. Threading: the rooms' thread.
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
  /// What it needs around it; all outlives it.
  struct Context {
    boost::asio::io_context& io;
    std::span<const std::unique_ptr<Shard>> shards;
    StoreWorker& store_worker;
    Backplane* backplane;  // null: there are no other hubs
    const Clock& clock;
    std::function<void(const std::string&)> complain;
    std::function<void(const Disconnect&)> on_let_go;  // the room knows this one no more
  };

  RoomRunner(RoomId id, Room room, Context around);

  [[nodiscard]] Room& room() { return room_; }
  [[nodiscard]] const Room& room() const { return room_; }
  [[nodiscard]] RoomId id() const { return id_; }
  [[nodiscard]] RoomTime now() const { return RoomTime(around_.clock.now().time_since_epoch()); }

  /// What one of the room's events returned.
  void apply(RoomActions actions);

  /// Sends this one away, who is in the room.
  void send_away(ConnectionId connection, wire::pb::ErrorCode code, const std::string& sentence);

  /// Nobody is in it any more.
  void close();

 private:
  void apply(const SendControl& action);
  void apply(const SendSet& action);
  void apply(const RestartSensor& action);
  void apply(const AcceptConnection& action);
  void apply(const Disconnect& action);
  void apply(const KeepSensors& action);
  void tell_backplane();
  void schedule_tick();
  [[nodiscard]] Shard& shard_of(ConnectionId connection) const {
    return *around_.shards[Shard::of(connection, around_.shards.size())];
  }

  const RoomId id_;
  Room room_;
  const Context around_;
  boost::asio::steady_timer timer_;
  std::optional<RoomTime> armed_for_;  // what timer_ waits for
  bool is_watched_ = false;            // the backplane knows
  std::uint64_t closed_sets_ = 0;      // as told
};

}  // namespace roomcast::hub
