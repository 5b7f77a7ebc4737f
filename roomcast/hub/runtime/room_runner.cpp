// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/runtime/room_runner.h"

#include <utility>

#include "roomcast/hub/runtime/control_message.h"

namespace roomcast::hub {

RoomRunner::RoomRunner(RoomId id, Room room, Context around)
    : id_(id), room_(std::move(room)), context_(std::move(around)), timer_(context_.io) {}

void RoomRunner::apply(RoomActions actions) {
  for (const RoomAction& action : actions) {
    std::visit([this](const auto& a) { apply(a); }, action);
  }
  schedule_tick();
  notify_backplane();
}

void RoomRunner::notify_backplane() {
  if (context_.backplane == nullptr) return;
  const std::uint64_t sets = room_.closed_set_count();
  if (std::exchange(closed_sets_, sets) != sets) context_.backplane->set_closed(room_.name());
  const bool is_watched = room_.viewer_count() > 0;
  if (is_watched == is_watched_) return;
  is_watched_ = is_watched;
  context_.backplane->watch(room_.name(), is_watched);
}

void RoomRunner::apply(const SendControl& action) {
  const auto message = framed_control(action.message);
  std::vector<std::vector<ConnectionId>> to(context_.shards.size());
  for (const ConnectionId connection : action.to) {
    if (is_of_backplane(connection)) {
      context_.backplane->send(connection, action.message);
      continue;
    }
    to[Shard::of(connection, to.size())].push_back(connection);
  }
  for (std::size_t i = 0; i < to.size(); ++i) {
    if (!to[i].empty()) context_.shards[i]->send_control(std::move(to[i]), message);
  }
}

void RoomRunner::apply(const SendSet& action) {
  for (const auto& shard : context_.shards) shard->send_set(id_, action.set);
}

void RoomRunner::apply(const RestartSensor& action) {
  for (const auto& shard : context_.shards) shard->restart_sensor(id_, action.sensor);
}

void RoomRunner::apply(const AcceptConnection& action) {
  if (is_of_backplane(action.connection)) return;  // the Welcome that follows tells the backplane
  shard_of(action.connection).accept(action.connection, action.role, id_);
}

void RoomRunner::apply(const Disconnect& action) {
  if (is_of_backplane(action.connection)) {
    context_.backplane->let_go(action.connection);
  } else {
    shard_of(action.connection).disconnect(action.connection, action.code, action.sentence);
  }
  context_.on_removed(action);
}

void RoomRunner::apply(const SaveSensors& action) {
  context_.store_worker.ask([room = room_.name(), sensors = action.sensors](
                                HubStore& book) { return book.sensors().save(room, sensors); },
                            [complain = context_.complain](const Status& status) {
                              if (!status) complain(status.error().message);
                            });
}

void RoomRunner::disconnect_client(ConnectionId connection, wire::pb::ErrorCode code,
                                   const std::string& sentence) {
  RoomActions actions = room_.leave(connection, now());
  actions.push_back(Disconnect{connection, code, sentence});
  apply(std::move(actions));
}

void RoomRunner::close() {
  timer_.cancel();
  for (const auto& shard : context_.shards) shard->forget(id_);
}

void RoomRunner::schedule_tick() {
  const auto next = room_.next_tick();
  if (!next || next == armed_for_) return;
  armed_for_ = next;
  timer_.expires_at(std::chrono::steady_clock::time_point(
      std::chrono::duration_cast<std::chrono::steady_clock::duration>(next->time_since_epoch())));
  timer_.async_wait([weak = weak_from_this()](boost::system::error_code error) {
    const auto self = weak.lock();
    if (error || self == nullptr) return;
    self->armed_for_.reset();
    self->apply(self->room_.tick(self->now()));
  });
}

}  // namespace roomcast::hub
