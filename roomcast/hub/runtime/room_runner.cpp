// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/runtime/room_runner.h"

#include <utility>

namespace roomcast::hub {

RoomRunner::RoomRunner(RoomId id, Room room, Context context)
    : id_(id), room_(std::move(room)), context_(std::move(context)), timer_(context_.io) {}

// ---- events

void RoomRunner::join(const ConnectionPtr& client, const wire::pb::Join& join, const Entry& entry) {
  connections_[client->id()] = client;
  if (context_.backplane != nullptr && join.has_sensor() && !entry.is_backplane) {
    context_.backplane->sensor_joins(name(), join.name(), entry.token_id);
  }
  apply(room_.join(client->id(), join, entry, now()));
}

void RoomRunner::leave(ConnectionId from) {
  connections_.erase(from);
  apply(room_.leave(from, now()));
}

void RoomRunner::control(ConnectionId from, const wire::pb::Control& message) {
  apply(room_.control(from, message, now()));
}

void RoomRunner::frame(ConnectionId from, const wire::FrameHeader& header,
                       net::MessageBuffer message) {
  // Other hubs get the full rendition only: they do not ask for the small one.
  if (context_.backplane != nullptr && !header.small && !room_.fault_of(from, header, now())) {
    context_.backplane->frame(name(), header, message.payload());
  }
  apply(room_.frame(from, header, std::move(message), now()));
}

void RoomRunner::audio(ConnectionId from, const wire::AudioHeader& header,
                       net::MessageBuffer message) {
  apply(room_.audio(from, header, std::move(message), now()));
}

void RoomRunner::frames(std::span<IncomingFrame> together) {
  apply(room_.frames(together, now()));
}

void RoomRunner::request_keys(const std::vector<SensorId>& sensors) {
  for (const SensorId sensor : sensors) apply(room_.key_needed(sensor, now()));
}

void RoomRunner::need_small(ConnectionId viewer, const SmallNeeds& needs) {
  apply(room_.small_needed(viewer, needs, now()));
}

void RoomRunner::watch_elsewhere(bool is_watched) {
  apply(room_.watch_elsewhere(is_watched, now()));
}

void RoomRunner::forget_sensor(const std::string& sensor) {
  apply(room_.forget(sensor, now()));
}

void RoomRunner::disconnect_client(ConnectionId client, wire::pb::ErrorCode code,
                                   const std::string& sentence) {
  if (!connections_.contains(client)) return;
  RoomActions actions = room_.leave(client, now());
  actions.push_back(Disconnect{client, code, sentence});
  apply(actions);
}

void RoomRunner::close(const std::string& sentence) {
  for (const ConnectionId client : room_.connections()) {
    disconnect_client(client, wire::pb::ERROR_NOT_ALLOWED, sentence);
  }
  timer_.stop();
  for (const auto& shard : context_.shards) shard->forget(id_);
}

void RoomRunner::schedule_tick() {
  const auto next = room_.next_tick();
  if (!next || next == armed_for_) return;
  armed_for_ = next;
  timer_.once(*next - now(), [weak = weak_from_this()] {
    const auto self = weak.lock();
    if (self == nullptr) return;
    self->armed_for_.reset();
    self->apply(self->room_.tick(self->now()));
  });
}

// ---- actions

void RoomRunner::apply(const RoomActions& actions) {
  for (const RoomAction& action : actions) {
    std::visit([this](const auto& a) { apply(a); }, action);
  }
  schedule_tick();
  notify_backplane();
}

void RoomRunner::notify_backplane() {
  if (context_.backplane == nullptr) return;
  const std::uint64_t sets = room_.closed_set_count();
  if (std::exchange(closed_sets_, sets) != sets) context_.backplane->set_closed(name());
  const bool is_watched = room_.viewer_count() > 0;
  if (is_watched == is_watched_) return;
  is_watched_ = is_watched;
  context_.backplane->watch(name(), is_watched);
}

/// Returns a share in the connection: a call of it may make it leave the room. Null: it has left.
ConnectionPtr RoomRunner::find(ConnectionId connection) const {
  const auto found = connections_.find(connection);
  return found == connections_.end() ? nullptr : found->second;
}

void RoomRunner::apply(const SendControl& action) {
  ControlFanOut control(action.message);
  for (const ConnectionId to : action.to) {
    if (const ConnectionPtr connection = find(to)) connection->deliver(control);
  }
  control.send();
}

void RoomRunner::apply(const SendSet& action) {
  for (const auto& shard : context_.shards) shard->send_set(id_, action.set);
}

void RoomRunner::apply(const SendAudio& action) {
  AudioFanOut audio(action.speaker, action.packet);
  for (const ConnectionId to : action.to) {
    if (const ConnectionPtr connection = find(to)) connection->hear(audio);
  }
  audio.send();
}

void RoomRunner::apply(const SetDetails& action) {
  if (const ConnectionPtr connection = find(action.viewer)) {
    connection->set_details(action.details);
  }
}

void RoomRunner::apply(const RestartSensor& action) {
  for (const auto& shard : context_.shards) shard->restart_sensor(id_, action.sensor);
}

void RoomRunner::apply(const AcceptConnection& action) {
  if (const ConnectionPtr connection = find(action.connection)) {
    connection->accept(action.role, id_);
  }
}

void RoomRunner::apply(const Disconnect& action) {
  if (const ConnectionPtr connection = find(action.connection)) {
    connections_.erase(action.connection);
    connection->disconnect(action.code, action.sentence);
  }
  context_.on_removed(action);
}

void RoomRunner::apply(const SaveSensors& action) {
  if (context_.on_placed) context_.on_placed(name(), action.sensors);
  context_.store_worker.ask([room = name(), sensors = action.sensors](
                                HubStore& store) { return store.sensors().save(room, sensors); },
                            [warn = context_.warn](const Status& status) {
                              if (!status) warn(status.error().message);
                            });
}

void RoomRunner::apply(const SaveMarks& action) {
  context_.store_worker.ask(
      [room = name(), action](HubStore& store) {
        return store.marks().save(room, action.added, action.removed);
      },
      [warn = context_.warn](const Status& status) {
        if (!status) warn(status.error().message);
      });
}

void RoomRunner::send(ConnectionId to, const wire::pb::Control& message) const {
  if (const ConnectionPtr connection = find(to)) connection->send(message);
}

}  // namespace roomcast::hub
