// SPDX-License-Identifier: Apache-2.0
// The AdminApi's calls about a room's events, and about the settings of its sensors, which are
// answered when the sensor has.
#include <cstdint>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "roomcast/hub/admin/admin_answer.h"
#include "roomcast/hub/admin/admin_api.h"
#include "roomcast/hub/admin/path_number.h"
#include "roomcast/hub/admin/sensor_settings_json.h"

namespace roomcast::hub {

namespace {

nlohmann::json event_json(const RoomEvent& event) {
  return {{"id", event.id},      {"number", event.number},
          {"at", event.at},      {"kind", event.kind},
          {"role", event.role},  {"name", event.name},
          {"peer", event.peer},  {"token_id", event.token_id},
          {"by", event.by},      {"sentence", event.sentence},
          {"times", event.times}};
}

}  // namespace

void AdminApi::list_events(const Call& call) const {
  const bool has_event = call.match.parameters.size() > 1;
  const auto after =
      has_event ? path_number<std::uint64_t>(call.parameter(1)) : std::optional<std::uint64_t>(0);
  if (!after)
    return call.respond(error_answer(400, "bad_request", "an event's number is a whole number"));
  const RoomEvents::Page page = registry_.events(call.parameter(0), *after);
  nlohmann::json events = nlohmann::json::array();
  for (const RoomEvent& event : page.events) events.push_back(event_json(event));
  call.respond(json_answer(200, {{"events", std::move(events)}, {"newest", page.newest}}));
}

void AdminApi::note(const Call& call, const char* kind, const std::string& name,
                    const std::string& sentence) const {
  registry_.note(call.parameter(0),
                 {.kind = kind,
                  .name = name,
                  .token_id = call.claims->id,
                  .by = call.claims->grant.name.empty() ? "an admin" : call.claims->grant.name,
                  .sentence = sentence});
}

void AdminApi::change_sensor(const Call& call) {
  if (nlohmann::json::parse(call.body, nullptr, false).contains("muted")) return mute_sensor(call);
  const auto request = read_settings_request(call.body);
  if (!request) return call.respond(error_answer(request.error()));
  registry_.ask_sensor(call.parameter(0), call.parameter(1), *request,
                       [this, call, wanted = described(*request)](const Status& outcome) {
                         const std::string& sensor = call.parameter(1);
                         if (!outcome) {
                           note(call, "sensor_refused", sensor,
                                wanted + ": " + outcome.error().message);
                           return call.respond(error_answer(outcome.error()));
                         }
                         note(call, "changed_sensor", sensor, wanted);
                         call.respond(json_answer(202, {{"sensor", sensor}, {"wanted", wanted}}));
                       });
}

}  // namespace roomcast::hub
