// SPDX-License-Identifier: Apache-2.0
// What the RoomRegistry tells those who run a room: its events. And what they tell its sensors.
#include <algorithm>
#include <utility>

#include "roomcast/hub/access/wall_clock.h"
#include "roomcast/hub/runtime/room_registry.h"

namespace roomcast::hub {

namespace {

constexpr char kTakesNone[] =
    "this sensor takes no settings from afar: it is no `roomcast sensor`, of an earlier version, "
    "or "
    "was started with --no-remote-settings";

}  // namespace

void RoomRegistry::note(const std::string& room, RoomEvent event) {
  if (rooms_.contains(room)) events_[room].add(std::move(event), wall_time());
}

RoomEvents::Page RoomRegistry::events(const std::string& room, std::uint64_t after) const {
  const auto found = events_.find(room);
  return found == events_.end() ? RoomEvents::Page() : found->second.after(after);
}

void RoomRegistry::note_client(const Client& client, const char* kind,
                               const std::string& sentence) {
  if (client.room == nullptr) return;
  note(client.room->name(), {.kind = kind,
                             .role = std::string(client.role),
                             .name = client.name,
                             .peer = client.address,
                             .token_id = client.token_id,
                             .sentence = sentence});
}

void RoomRegistry::note_message(ConnectionId from, const wire::pb::Control& message) {
  if (!message.has_sensor_moved() && !message.has_nudge()) return;
  const auto found = clients_.find(from);
  if (found == clients_.end() || found->second.room == nullptr) return;
  const Client& client = found->second;
  if (message.has_sensor_moved()) return note_client(client, "moved", "");
  const auto sensors = client.room->stats().sensors;
  const auto sensor = std::ranges::find_if(
      sensors,
      [id = message.nudge().sensor_id()](const SensorStats& s) { return s.id.value == id; });
  if (sensor == sensors.end() || client.role != "viewer") return;
  note(client.room->name(),
       {.kind = "nudged", .role = "sensor", .name = sensor->name, .by = client.name});
}

/// A sensor whose pose is known now and was not before, or the reverse.
void RoomRegistry::note_places(const std::string& room, const std::vector<KnownSensor>& sensors) {
  for (const KnownSensor& sensor : sensors) {
    auto& placed = placed_[room];
    const bool is_news =
        sensor.pose ? placed.insert(sensor.name).second : placed.erase(sensor.name) > 0;
    if (!is_news) continue;
    note(room, {.kind = sensor.pose ? "placed" : "lost_place",
                .role = "sensor",
                .name = sensor.name,
                .sentence = sensor.pose ? sensor.pose->note : ""});
  }
}

void RoomRegistry::ask_sensor(const std::string& room, const std::string& sensor,
                              wire::pb::SettingsRequest request,
                              SensorRequests::Answered answered) {
  const auto sensors = rooms_.at(room)->stats().sensors;
  const auto found = std::ranges::find(sensors, sensor, &SensorStats::name);
  if (found == sensors.end() || !found->online)
    return answered(Error{ErrorCode::kNotFound, "no such sensor is online in this room"});
  if (!found->settings) return answered(invalid_argument(kTakesNone));
  const auto number = requests_.open(found->connection, clock_.now(), std::move(answered));
  if (number == 0) return;
  wire::pb::Control message;
  request.set_number(number);
  *message.mutable_settings_request() = std::move(request);
  rooms_.at(room)->send(found->connection, message);
}

}  // namespace roomcast::hub
