// SPDX-License-Identifier: Apache-2.0
// Backplane: brings into a hub's rooms what other hubs have. It says what its sensors say through
// SessionEvents, as if each had a connection of its own here, and is told what the room says to
// them. Threading: the rooms' thread.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include <boost/asio/io_context.hpp>

#include "roomcast/core/ids.h"
#include "roomcast/hub/session.h"

namespace roomcast::hub {

// A backplane's connections are not those of any shard: their ids have the highest bit.
inline constexpr std::uint64_t kBackplaneBit = std::uint64_t{1} << 63;

/// `owner` below 2^31 is for the backplane's own use.
[[nodiscard]] inline ConnectionId backplane_connection(std::uint32_t owner, std::uint32_t number) {
  return ConnectionId{kBackplaneBit | std::uint64_t{owner} << 32 | number};
}
[[nodiscard]] inline bool is_of_backplane(ConnectionId connection) {
  return (connection.value & kBackplaneBit) != 0;
}
[[nodiscard]] inline std::uint32_t backplane_owner(ConnectionId connection) {
  return static_cast<std::uint32_t>((connection.value & ~kBackplaneBit) >> 32);
}

class Backplane {
 public:
  virtual ~Backplane() = default;
  /// Somebody here sees this room now, or nobody any more.
  virtual void watch(const std::string& room, bool is_watched) = 0;
  /// What the room says to one of the backplane's connections.
  virtual void send(ConnectionId to, const wire::pb::Control& message) = 0;
  /// The room knows it no more.
  virtual void let_go(ConnectionId connection) = 0;
};

/// Where a backplane works; outlives it.
struct BackplaneSeat {
  boost::asio::io_context& io;
  SessionEvents& rooms;
  std::string token;  // with which it may join every room
};
using OpenBackplane = std::function<std::unique_ptr<Backplane>(BackplaneSeat)>;

}  // namespace roomcast::hub
