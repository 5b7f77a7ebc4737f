// SPDX-License-Identifier: Apache-2.0
// The RoomRegistry's tasks of every second: expired and revoked tokens, and traffic rates.
#include <utility>

#include "roomcast/hub/access/wall_clock.h"
#include "roomcast/hub/runtime/room_registry.h"

namespace roomcast::hub {

namespace {

constexpr std::chrono::seconds kTaskInterval{1};
constexpr std::chrono::seconds kForgetAfter{10};

}  // namespace

void RoomRegistry::start() {
  timer_.repeat(kTaskInterval, [this] { run_periodic_tasks(); });
}

void RoomRegistry::run_periodic_tasks() {
  measure_sensors();
  requests_.give_up_before(clock_.now());
  for (std::size_t i = 0; i < shards_.size(); ++i) {
    shards_[i]->report_traffic([this, i](const ShardTraffic& t) { record_traffic(i, t); });
  }
  disconnect_expired();
  store_worker_.ask(
      [](HubStore& store) {
        if (!store.changed_elsewhere()) return std::vector<Claims>();
        auto revoked = store.revoked();
        return revoked ? *std::move(revoked) : std::vector<Claims>();
      },
      [this](const std::vector<Claims>& revoked) {
        if (revoked.empty()) return;
        std::vector<std::string> ids;
        for (const Claims& token : revoked) ids.push_back(token.id);
        disconnect_token_holders(ids);
        if (backplane_ != nullptr) backplane_->revoked(revoked);
        send_revoked_to_downstream(revoked);
      });
}

void RoomRegistry::disconnect_expired() {
  const UnixSeconds now = wall_time();
  std::vector<std::pair<ConnectionId, RoomRunner*>> expired;
  for (const auto& [connection, client] : clients_) {
    if (client.room != nullptr && client.expires_at != 0 && client.expires_at <= now) {
      expired.emplace_back(connection, client.room);
    }
  }
  for (const auto& [connection, room] : expired) {
    room->disconnect_client(connection, wire::pb::ERROR_TOKEN_EXPIRED,
                            "this token has expired; ask for a new one");
  }
}

void RoomRegistry::measure_sensors() {
  const HostTime now = clock_.now();
  for (const auto& [name, room] : rooms_) {
    for (const SensorStats& sensor : room->stats().sensors) {
      if (!sensor.online) continue;
      sensor_bytes_.sample(sensor.connection, sensor.bytes, now);
      sensor_frames_.sample(sensor.connection, sensor.frames, now);
    }
  }
  sensor_bytes_.forget_before(now - kForgetAfter);
  sensor_frames_.forget_before(now - kForgetAfter);
  viewer_bytes_.forget_before(now - kForgetAfter);
  std::erase_if(sent_, [this](const auto& entry) { return !clients_.contains(entry.first); });
}

void RoomRegistry::record_traffic(std::size_t shard, const ShardTraffic& traffic) {
  const HostTime now = clock_.now();
  for (const auto& viewer : traffic.viewers) {
    if (!clients_.contains(viewer.connection)) continue;
    sent_[viewer.connection] = {viewer.bytes, viewer.dropped_sets, viewer.dropped_audio};
    viewer_bytes_.sample(viewer.connection, viewer.bytes, now);
  }
  for (const auto& room : traffic.rooms) dropped_sets_[{room.room, shard}] = room.dropped_sets;
}

std::string RoomRegistry::address_of(ConnectionId client) const {
  const auto found = clients_.find(client);
  return found == clients_.end() ? "" : found->second.address;
}

std::vector<RoomStats> RoomRegistry::stats() const {
  std::vector<RoomStats> all;
  for (const auto& [name, room] : rooms_) all.push_back(stats_of(*room));
  return all;
}

std::optional<RoomStats> RoomRegistry::stats(const std::string& room) const {
  const auto found = rooms_.find(room);
  if (found == rooms_.end()) return std::nullopt;
  return stats_of(*found->second);
}

RoomStats RoomRegistry::stats_of(const RoomRunner& room) const {
  RoomStats stats = room.stats();
  for (SensorStats& sensor : stats.sensors) {
    if (!sensor.online) continue;
    sensor.frames_per_s = sensor_frames_.per_s(sensor.connection);
    sensor.bytes_per_s = sensor_bytes_.per_s(sensor.connection);
  }
  for (ViewerStats& viewer : stats.viewers) {
    const auto sent = sent_.find(viewer.connection);
    if (sent == sent_.end()) continue;
    viewer.bytes = sent->second.bytes;
    viewer.dropped_sets = sent->second.dropped_sets;
    viewer.dropped_audio = sent->second.dropped_audio;
    viewer.bytes_per_s = viewer_bytes_.per_s(viewer.connection);
  }
  for (std::size_t shard = 0; shard < shards_.size(); ++shard) {
    const auto dropped = dropped_sets_.find({room.id(), shard});
    if (dropped != dropped_sets_.end()) stats.dropped_sets += dropped->second;
  }
  return stats;
}

}  // namespace roomcast::hub
