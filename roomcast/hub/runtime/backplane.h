// SPDX-License-Identifier: Apache-2.0
// Backplane: brings the sensors and people of other hubs into this hub's rooms, and sends other
// hubs what they request of this one. It represents each remote sensor by a Connection: the
// sensor's messages enter through BackplaneEvents, and the room's messages go to the Connection.
// Threading: the rooms' thread.
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
#include "roomcast/hub/runtime/connection.h"
#include "roomcast/hub/runtime/session.h"

namespace roomcast::hub {

/// The state of one of several hubs.
struct HubStatus {
  std::string id;
  std::string public_url;  // empty: not reachable for viewers of other hubs
  float load = 0;          // number of processor cores in use
  struct Room {
    std::string name;
    std::size_t sensors = 0, viewers = 0;  // connected to that hub
  };
  std::vector<Room> rooms = {};  // rooms that have, or have had, clients
};

struct BackplaneTraffic {
  std::uint64_t messages = 0, bytes = 0;
};

/// The state of a backplane and its counters since the hub was started.
struct BackplaneStats {
  std::size_t links = 0;       // links it needs: to NATS, or one per room pulled from another hub
  std::size_t links_up = 0;    // links that are connected
  std::size_t other_hubs = 0;  // with a recent heartbeat
  BackplaneTraffic sent = {}, received = {};
  std::uint64_t dropped = 0;  // messages that could not be sent
};

class Backplane {
 public:
  virtual ~Backplane() = default;
  virtual void room_opened(const std::string& /*room*/) {}
  virtual void room_closed(const std::string& /*room*/) {}
  /// A sensor that is connected to this hub was admitted. `token_id`: of the token that it
  /// presented.
  virtual void sensor_joins(const std::string& /*room*/, const std::string& /*name*/,
                            const std::string& /*token_id*/) {}
  /// A frame of such a sensor, which the room accepts.
  virtual void frame(const std::string& /*room*/, const wire::FrameHeader& /*header*/,
                     std::span<const std::uint8_t> /*message*/) {}
  /// The room has closed a set, after frame() was called for its frames.
  virtual void set_closed(const std::string& /*room*/) {}
  /// All revoked tokens of this hub.
  virtual void revoked(const std::vector<Claims>& /*tokens*/) {}
  /// The hubs that are alive, this one first; empty: this hub is the only one.
  [[nodiscard]] virtual std::vector<HubStatus> hubs() const { return {}; }
  [[nodiscard]] virtual BackplaneStats stats() const { return {}; }
  /// Public URLs of hubs that a viewer of this room should use instead; empty: it may stay here.
  [[nodiscard]] virtual std::vector<std::string> less_busy_hubs(const std::string& /*room*/) const {
    return {};
  }
  /// The room's first viewer here has joined, or its last one has left.
  virtual void watch(const std::string& room, bool is_watched) = 0;
};

/// Messages and frames that a backplane brings in.
class BackplaneEvents : public SessionEvents {
 public:
  /// Frames of sensors of one room at other hubs that arrived together. The room takes them in one
  /// event: it closes sets, and does the other work after an event, once for all. Their messages
  /// are moved from.
  virtual void on_frames(std::span<IncomingFrame> together) = 0;
  /// The first viewer of a room at another hub wants frames of this hub's sensors, or the last one
  /// has left.
  virtual void on_watched_elsewhere(const std::string& room, bool is_watched) = 0;
};

/// The hub's interface for a backplane; outlives it.
struct BackplaneContext {
  boost::asio::io_context& io;
  BackplaneEvents& rooms;
  ConnectionIds& connection_ids;  // for the backplane's connections
  std::string token;              // permits joining every room
  /// Takes the tokens that other hubs report as revoked.
  std::function<void(std::vector<Claims>)> revoke = {};
  /// Requests the revoked tokens; the answer is a call of Backplane::revoked() if there are any.
  std::function<void()> send_revoked = {};
  /// Takes the public URLs of the other hubs. This hub's page may reconnect to them, and their
  /// pages to this hub.
  std::function<void(std::vector<std::string>)> set_peer_urls = {};
};
using OpenBackplane = std::function<Result<std::unique_ptr<Backplane>>(BackplaneContext)>;

}  // namespace roomcast::hub
