// SPDX-License-Identifier: Apache-2.0
// Backplane: brings into a hub's rooms what other hubs have, and to other hubs what they want of
// this one. It says what its sensors say through BackplaneEvents, as if each had a connection of
// its own here, and is told what the room says to them. Threading: the rooms' thread.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <boost/asio/io_context.hpp>

#include "roomcast/core/ids.h"
#include "roomcast/core/result.h"
#include "roomcast/hub/access/claims.h"
#include "roomcast/hub/room/backplane_connection.h"
#include "roomcast/hub/runtime/session.h"

namespace roomcast::hub {

/// One of several hubs.
struct HubStatus {
  std::string id;
  std::string public_url;  // empty: not for others
  float load = 0;          // processor cores that it uses
  struct Room {
    std::string name;
    std::size_t sensors = 0, viewers = 0;  // connected there
  };
  std::vector<Room> rooms = {};  // where somebody is, or was
};

struct BackplaneTraffic {
  std::uint64_t messages = 0, bytes = 0;
};

/// How a backplane is doing, since the hub was started.
struct BackplaneStats {
  std::size_t links = 0;     // that it wants: to NATS, or one for each room pulled from another hub
  std::size_t links_up = 0;  // of these
  std::size_t other_hubs = 0;  // heard of lately
  BackplaneTraffic sent = {}, received = {};
  std::uint64_t dropped = 0;  // messages that could not be sent
};

class Backplane {
 public:
  virtual ~Backplane() = default;
  virtual void room_opened(const std::string& /*room*/) {}
  virtual void room_closed(const std::string& /*room*/) {}
  /// A sensor is let in that has a connection here. `token_id`: of the token that it showed.
  virtual void sensor_joins(const std::string& /*room*/, const std::string& /*name*/,
                            const std::string& /*token_id*/) {}
  /// Of such a sensor; the room takes it.
  virtual void frame(const std::string& /*room*/, const wire::FrameHeader& /*header*/,
                     std::span<const std::uint8_t> /*message*/) {}
  /// The room has closed a set: its frames have all been told.
  virtual void set_closed(const std::string& /*room*/) {}
  /// All tokens of this hub that hold no more.
  virtual void revoked(const std::vector<Claims>& /*tokens*/) {}
  /// Those that are there now, this one first; empty: this one is alone.
  [[nodiscard]] virtual std::vector<HubStatus> hubs() const { return {}; }
  [[nodiscard]] virtual BackplaneStats stats() const { return {}; }
  /// Where somebody who comes to watch this room should rather go; empty: he may stay here.
  [[nodiscard]] virtual std::vector<std::string> less_busy_hubs(const std::string& /*room*/) const {
    return {};
  }
  /// Somebody here sees this room now, or nobody any more.
  virtual void watch(const std::string& room, bool is_watched) = 0;
  /// What the room says to one of the backplane's connections.
  virtual void send(ConnectionId to, const wire::pb::Control& message) = 0;
  /// The room knows it no more.
  virtual void let_go(ConnectionId connection) = 0;
};

/// What comes in from a backplane.
class BackplaneEvents : public SessionEvents {
 public:
  /// These came together, of sensors of one room: what they close goes on as it came, and nobody
  /// is looked after once for each. Their messages are taken.
  virtual void on_frames(std::span<IncomingFrame> together) = 0;
};

/// Where a backplane works; outlives it.
struct BackplaneContext {
  boost::asio::io_context& io;
  BackplaneEvents& rooms;
  std::string token;  // with which it may join every room
  /// These tokens hold no more, say other hubs.
  std::function<void(std::vector<Claims>)> revoke = {};
  /// Answered by Backplane::revoked().
  std::function<void()> tell_revoked = {};
  /// Addresses of the other hubs that are for others: the page may go on there, and theirs here.
  std::function<void(std::vector<std::string>)> name_hubs = {};
};
using OpenBackplane = std::function<Result<std::unique_ptr<Backplane>>(BackplaneContext)>;

}  // namespace roomcast::hub
