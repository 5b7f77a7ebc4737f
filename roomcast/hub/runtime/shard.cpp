// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/runtime/shard.h"

#include <algorithm>
#include <utility>

#include <boost/asio/dispatch.hpp>
#include <boost/asio/steady_timer.hpp>

#include "roomcast/wire/limits.h"

namespace roomcast::hub {

namespace asio = boost::asio;

namespace {

/// A session, reached through its shard.
class SessionConnection final : public Connection {
 public:
  SessionConnection(ConnectionId id, Shard& shard) : Connection(id), shard_(shard) {}

  void accept(Role role, RoomId room) override { shard_.accept(id(), role, room); }
  void deliver(ControlFanOut& control) override { control.add(shard_, id()); }
  void hear(AudioFanOut& audio) override { audio.add(shard_, id()); }
  void set_details(const SensorDetails& details) override { shard_.set_details(id(), details); }
  void disconnect(wire::pb::ErrorCode code, const std::string& sentence) override {
    shard_.disconnect(id(), code, sentence);
  }

 private:
  Shard& shard_;
};

}  // namespace

Shard::Shard(Loops loops, SessionEvents& room, ConnectionIds& ids, UnjoinedCount& unjoined,
             ShardLimits limits)
    : loops_(loops), room_(room), ids_(ids), unjoined_(unjoined), limits_(limits) {}

std::shared_ptr<net::ConnectionHandler> Shard::add_session(
    const std::shared_ptr<net::WebSocketConnection>& connection) {
  if (unjoined_ >= limits_.max_unjoined) return nullptr;
  ++unjoined_;
  const ConnectionId id = ids_.next();
  auto session = std::make_shared<Session>(std::make_shared<SessionConnection>(id, *this),
                                           *connection, *this, clock_, limits_.session);
  sessions_[id] = session;
  start_join_deadline(id);
  return session;
}

void Shard::start_join_deadline(ConnectionId id) {
  auto deadline = std::make_shared<asio::steady_timer>(loops_.io, limits_.join_within);
  deadline->async_wait([this, id, deadline](boost::system::error_code error) {
    Session* session = find(id);
    if (error || session == nullptr || session->has_joined()) return;
    session->disconnect(wire::pb::ERROR_UNEXPECTED, "no Join arrived in time");
  });
}

Session* Shard::find(ConnectionId id) const {
  const auto found = sessions_.find(id);
  return found == sessions_.end() ? nullptr : found->second.get();
}

// ---- actions from the room

void Shard::accept(ConnectionId connection, Role role, RoomId room) {
  asio::dispatch(loops_.io, [this, connection, role, room] {
    Session* session = find(connection);
    if (session == nullptr) return;
    session->accept(role);
    --unjoined_;
    const bool gets_frames = role == Role::kViewer || role == Role::kHub || role == Role::kModeler;
    if (gets_frames) viewers_[room].sessions.push_back(session);
  });
}

void Shard::send_control(std::vector<ConnectionId> to, net::FramedMessagePtr message) {
  asio::dispatch(loops_.io, [this, to = std::move(to), message = std::move(message)] {
    for (const ConnectionId connection : to) {
      Session* session = find(connection);
      if (session == nullptr || session->send_control(message)) continue;
      session->disconnect(wire::pb::ERROR_TOO_SLOW, "too many control messages are unread");
    }
  });
}

void Shard::send_set(RoomId room, FrameSetPtr set) {
  asio::dispatch(loops_.io, [this, room, set = std::move(set)] {
    const auto found = viewers_.find(room);
    if (found == viewers_.end()) return;
    std::uint64_t dropped = 0;
    for (Session* viewer : found->second.sessions) {
      dropped -= viewer->dropped_sets();
      viewer->send_set(set);
      dropped += viewer->dropped_sets();
    }
    found->second.dropped_sets += dropped;
  });
}

void Shard::send_audio(std::vector<ConnectionId> to, ViewerId speaker,
                       net::FramedMessagePtr packet) {
  asio::dispatch(loops_.io, [this, to = std::move(to), speaker, packet = std::move(packet)] {
    for (const ConnectionId connection : to) {
      if (Session* session = find(connection)) session->send_audio(speaker, packet);
    }
  });
}

void Shard::set_details(ConnectionId viewer, SensorDetails details) {
  asio::dispatch(loops_.io, [this, viewer, details = std::move(details)]() mutable {
    if (Session* session = find(viewer)) session->set_details(std::move(details));
  });
}

void Shard::restart_sensor(RoomId room, SensorId sensor) {
  asio::dispatch(loops_.io, [this, room, sensor] {
    const auto found = viewers_.find(room);
    if (found == viewers_.end()) return;
    for (Session* viewer : found->second.sessions) viewer->restart_sensor(sensor);
  });
}

void Shard::forget(RoomId room) {
  asio::dispatch(loops_.io, [this, room] { viewers_.erase(room); });
}

void Shard::report_traffic(std::function<void(ShardTraffic)> to) {
  asio::dispatch(loops_.io, [this, to = std::move(to)] {
    ShardTraffic traffic;
    for (const auto& [room, viewers] : viewers_) {
      traffic.rooms.push_back({room, viewers.dropped_sets});
      for (const Session* viewer : viewers.sessions) {
        traffic.viewers.push_back(
            {viewer->id(), viewer->bytes_out(), viewer->dropped_sets(), viewer->dropped_audio()});
      }
    }
    asio::dispatch(loops_.room_io,
                   [to, traffic = std::move(traffic)]() mutable { to(std::move(traffic)); });
  });
}

void Shard::disconnect(ConnectionId connection, wire::pb::ErrorCode code, std::string sentence) {
  asio::dispatch(loops_.io, [this, connection, code, sentence = std::move(sentence)] {
    if (Session* session = find(connection)) session->disconnect(code, sentence);
  });
}

// ---- events to the room

void Shard::on_join(const ConnectionInfo& connection_info, const wire::pb::Join& join) {
  asio::dispatch(loops_.room_io,
                 [this, connection_info, join] { room_.on_join(connection_info, join); });
}

void Shard::on_control(ConnectionId from, const wire::pb::Control& message) {
  asio::dispatch(loops_.room_io, [this, from, message] { room_.on_control(from, message); });
}

void Shard::on_frame(ConnectionId from, const wire::FrameHeader& header,
                     net::MessageBuffer message) {
  asio::dispatch(loops_.room_io, [this, from, header, message = std::move(message)]() mutable {
    room_.on_frame(from, header, std::move(message));
  });
}

void Shard::on_audio(ConnectionId from, const wire::AudioHeader& header,
                     net::MessageBuffer message) {
  asio::dispatch(loops_.room_io, [this, from, header, message = std::move(message)]() mutable {
    room_.on_audio(from, header, std::move(message));
  });
}

void Shard::on_key_needs(ConnectionId from, const std::vector<SensorId>& sensors) {
  asio::dispatch(loops_.room_io, [this, from, sensors] { room_.on_key_needs(from, sensors); });
}

void Shard::on_small_needs(ConnectionId from, const SmallNeeds& needs) {
  asio::dispatch(loops_.room_io, [this, from, needs] { room_.on_small_needs(from, needs); });
}

void Shard::on_left(ConnectionId from, const net::CloseReason& reason) {
  const auto found = sessions_.find(from);
  if (!found->second->is_accepted()) --unjoined_;
  for (auto& [room, viewers] : viewers_) std::erase(viewers.sessions, found->second.get());
  sessions_.erase(found);
  asio::dispatch(loops_.room_io, [this, from, reason] { room_.on_left(from, reason); });
}

}  // namespace roomcast::hub
