// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/shard.h"

#include <algorithm>
#include <utility>

#include <boost/asio/dispatch.hpp>
#include <boost/asio/steady_timer.hpp>

#include "roomcast/wire/limits.h"

namespace roomcast::hub {

namespace asio = boost::asio;

Shard::Shard(Place place, SessionEvents& room, UnjoinedCount& unjoined,
             std::chrono::milliseconds join_within)
    : place_(place),
      room_(room),
      unjoined_(unjoined),
      join_within_(join_within),
      next_connection_(place.count + place.index) {}

std::shared_ptr<net::ConnectionHandler> Shard::welcome(
    const std::shared_ptr<net::WebSocketConnection>& connection) {
  if (unjoined_ >= wire::kMaxUnjoinedConnections) return nullptr;
  ++unjoined_;
  const ConnectionId id{next_connection_};
  next_connection_ += place_.count;
  auto session = std::make_shared<Session>(id, *connection, *this, clock_);
  sessions_[id] = session;
  expect_join(id);
  return session;
}

void Shard::expect_join(ConnectionId id) {
  auto deadline = std::make_shared<asio::steady_timer>(place_.io, join_within_);
  deadline->async_wait([this, id, deadline](boost::system::error_code error) {
    Session* session = find(id);
    if (error || session == nullptr || session->has_joined()) return;
    session->disconnect(wire::pb::ERROR_UNEXPECTED, "no Join came in time after connecting");
  });
}

Session* Shard::find(ConnectionId id) const {
  const auto found = sessions_.find(id);
  return found == sessions_.end() ? nullptr : found->second.get();
}

// ---- from the room

void Shard::accept(ConnectionId connection, Role role) {
  asio::dispatch(place_.io, [this, connection, role] {
    Session* session = find(connection);
    if (session == nullptr) return;
    session->accept(role);
    --unjoined_;
    if (role == Role::kViewer) viewers_.push_back(session);
  });
}

void Shard::send_control(std::vector<ConnectionId> to, net::SealedMessagePtr message) {
  asio::dispatch(place_.io, [this, to = std::move(to), message = std::move(message)] {
    for (const ConnectionId connection : to) {
      Session* session = find(connection);
      if (session == nullptr || session->send_control(message)) continue;
      session->disconnect(wire::pb::ERROR_TOO_SLOW, "control messages pile up unread");
    }
  });
}

void Shard::send_set(FrameSetPtr set) {
  asio::dispatch(place_.io, [this, set = std::move(set)] {
    std::uint64_t dropped = 0;
    for (Session* viewer : viewers_) {
      dropped -= viewer->dropped_sets();
      viewer->send_set(set);
      dropped += viewer->dropped_sets();
    }
    dropped_sets_ += dropped;
  });
}

void Shard::restart_sensor(SensorId sensor) {
  asio::dispatch(place_.io, [this, sensor] {
    for (Session* viewer : viewers_) viewer->restart_sensor(sensor);
  });
}

void Shard::disconnect(ConnectionId connection, wire::pb::ErrorCode code, std::string sentence) {
  asio::dispatch(place_.io, [this, connection, code, sentence = std::move(sentence)] {
    if (Session* session = find(connection)) session->disconnect(code, sentence);
  });
}

// ---- to the room

void Shard::on_join(ConnectionId from, const wire::pb::Join& join) {
  asio::dispatch(place_.room_io, [this, from, join] { room_.on_join(from, join); });
}

void Shard::on_control(ConnectionId from, const wire::pb::Control& message) {
  asio::dispatch(place_.room_io, [this, from, message] { room_.on_control(from, message); });
}

void Shard::on_frame(ConnectionId from, const wire::FrameHeader& header,
                     net::MessageBuffer message) {
  asio::dispatch(place_.room_io, [this, from, header, message = std::move(message)]() mutable {
    room_.on_frame(from, header, std::move(message));
  });
}

void Shard::on_key_needs(const std::vector<SensorId>& sensors) {
  asio::dispatch(place_.room_io, [this, sensors] { room_.on_key_needs(sensors); });
}

void Shard::on_left(ConnectionId from, const net::CloseReason& reason) {
  const auto found = sessions_.find(from);
  if (!found->second->is_accepted()) --unjoined_;
  std::erase(viewers_, found->second.get());
  sessions_.erase(found);
  asio::dispatch(place_.room_io, [this, from, reason] { room_.on_left(from, reason); });
}

}  // namespace roomcast::hub
