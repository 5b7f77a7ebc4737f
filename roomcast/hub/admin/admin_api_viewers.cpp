// SPDX-License-Identifier: Apache-2.0
// The AdminApi's calls about a room's viewers: the list, mute, end; and muting sensors'
// microphones.
#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "roomcast/hub/admin/admin_answer.h"
#include "roomcast/hub/admin/admin_api.h"
#include "roomcast/wire/audio_header.h"

namespace roomcast::hub {

namespace {

net::HttpResponse not_a_mute() {
  return error_answer(400, "bad_request",
                      R"(the body must be {"muted": true} or {"muted": false})");
}

/// {"muted": true}; nothing: the body is something else.
std::optional<bool> muted_in(const std::string& body) {
  const auto json = nlohmann::json::parse(body, nullptr, false);
  if (!json.is_object() || json.size() != 1) return std::nullopt;
  const auto muted = json.find("muted");
  if (muted == json.end() || !muted->is_boolean()) return std::nullopt;
  return muted->get<bool>();
}

}  // namespace

void AdminApi::list_viewers(const Call& call) const {
  nlohmann::json viewers = nlohmann::json::array();
  const RoomStats stats = *registry_.stats(call.parameter(0));
  for (const ViewerStats& viewer : stats.viewers) {
    viewers.push_back(viewer_json(viewer, registry_.address_of(viewer.connection)));
  }
  call.respond(json_answer(200, {{"viewers", std::move(viewers)}}));
}

/// The viewer that the call names; nothing: the call has been answered.
std::optional<ViewerStats> AdminApi::viewer_of(const Call& call) const {
  std::uint32_t id = 0;
  const std::string& text = call.parameter(1);
  std::from_chars(text.data(), text.data() + text.size(), id);
  const RoomStats stats = *registry_.stats(call.parameter(0));
  const auto found = std::ranges::find(stats.viewers, ViewerId{id}, &ViewerStats::id);
  if (found != stats.viewers.end()) return *found;
  call.respond(error_answer(404, "not_found", "no such viewer is in this room"));
  return std::nullopt;
}

void AdminApi::change_viewer(const Call& call) {
  const auto muted = muted_in(call.body);
  if (!muted) return call.respond(not_a_mute());
  const auto viewer = viewer_of(call);
  if (!viewer) return;
  registry_.mute(call.parameter(0), viewer->id, *muted);
  note(call, *muted ? "muted" : "unmuted", viewer->name);
  if (const auto changed = viewer_of(call))
    call.respond(
        json_answer(200, viewer_json(*changed, registry_.address_of(changed->connection))));
}

void AdminApi::mute_sensor(const Call& call) {
  const auto muted = muted_in(call.body);
  if (!muted) return call.respond(not_a_mute());
  const std::string& room = call.parameter(0);
  const auto find = [&](const RoomStats& stats) -> std::optional<SensorStats> {
    const auto found = std::ranges::find(stats.sensors, call.parameter(1), &SensorStats::name);
    return found == stats.sensors.end() ? std::nullopt : std::optional(*found);
  };
  const auto sensor = find(*registry_.stats(room));
  if (!sensor)
    return call.respond(error_answer(404, "not_found", "no such sensor is in this room"));
  registry_.mute(room, wire::speaker_of(sensor->id), *muted);
  note(call, *muted ? "muted" : "unmuted", sensor->name);
  if (const auto changed = find(*registry_.stats(room)))
    call.respond(
        json_answer(200, sensor_json(*changed, registry_.address_of(changed->connection))));
}

void AdminApi::end_viewer(const Call& call) {
  const auto viewer = viewer_of(call);
  if (!viewer) return;
  note(call, "ended", viewer->name);
  registry_.disconnect_client(viewer->connection, "the room's owner ended this connection");
  call.respond(no_content());
}

}  // namespace roomcast::hub
