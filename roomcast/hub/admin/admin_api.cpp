// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/admin/admin_api.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <nlohmann/json.hpp>

#include "roomcast/hub/admin/admin_answer.h"
#include "roomcast/hub/admin/token_request.h"

namespace roomcast::hub {

namespace {

using Json = nlohmann::json;
namespace pb = wire::pb;

net::HttpResponse not_yours() {
  return error_answer(403, "wrong_role", "this request needs an admin's token for it");
}

net::HttpResponse is_nowhere(NoRoute reason) {
  if (reason == NoRoute::kUnknownMethod) {
    return error_answer(405, "method_not_allowed", "this address does not support this method");
  }
  return error_answer(404, "not_found", "there is nothing at this address");
}

/// Nothing: the body is not a JSON object.
std::optional<Json> object_in(const std::string& body) {
  Json json = Json::parse(body, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  return json;
}

/// Their names, with commas.
std::string fields_that_differ(const RoomSettings& before, const RoomSettings& after) {
  const Json was = to_json(before), is = to_json(after);
  std::string names;
  for (const auto& [field, value] : is.items()) {
    if (was.at(field) != value) names += (names.empty() ? "" : ", ") + field;
  }
  return names;
}

net::HttpResponse no_object() {
  return error_answer(400, "bad_request", "the body must be a JSON object");
}

}  // namespace

AdminApi::AdminApi(RoomRegistry& registry, StoreWorker& store_worker, std::string version,
                   RoomRecordings* recordings, StudyDesk* study, RoomModels* models, LogSink log)
    : registry_(registry),
      store_worker_(store_worker),
      version_(std::move(version)),
      recordings_(recordings),
      models_(models),
      auth_(registry, store_worker, std::move(log)),
      study_(study) {}

void AdminApi::answer(const net::HttpRequest& request, net::Respond respond) {
  const auto found = match_admin_route(request.method, request.path);
  if (const auto* reason = std::get_if<NoRoute>(&found)) return respond(is_nowhere(*reason));
  const auto& match = std::get<MatchedRoute>(found);
  if (StudyApi::has(match.route.call)) return answer_participant(request, match, respond);
  auth_.admit(request, match.route.needs_token, std::move(respond),
              [this, match, body = request.body](Caller caller) {
                apply({std::move(caller), match, body});
              });
}

/// To begin takes a token where viewing the study's room takes one; later the participant's key is
/// enough.
void AdminApi::answer_participant(const net::HttpRequest& request, const MatchedRoute& match,
                                  const net::Respond& respond) {
  const RoomSettings* room = registry_.find(study_.room());
  const bool needs_token = room != nullptr && room->view != AccessRule::kAnyone;
  if (match.route.call != AdminCall::kEnroll || !needs_token)
    return study_.answer(match, request.body, respond);
  auth_.admit(request, true, respond, [this, match, body = request.body](const Caller& caller) {
    const bool may = caller.claims && covers(caller.claims->grant, study_.room());
    if (may) return study_.answer(match, body, caller.respond);
    caller.respond(error_answer(403, "wrong_room", "this token is for another room"));
  });
}

void AdminApi::apply(const Call& call) {
  switch (call.match.route.call) {
    case AdminCall::kStatus:
      return status(call);
    case AdminCall::kListHubs:
      return list_hubs(call);
    case AdminCall::kListRooms:
      return list_rooms(call);
    case AdminCall::kOpenRoom:
      return open_room(call);
    case AdminCall::kRoom:
      return room(call);
    case AdminCall::kRoomModel:
      return room_model(call);
    case AdminCall::kDownload:
      return download(call);
    case AdminCall::kListTokens:
      return list_tokens(call);
    case AdminCall::kMakeToken:
      return make_token(call);
    case AdminCall::kRevokeToken:
      return revoke_token(call);
    default:
      return carry_out_in_room(call);
  }
}

/// Calls for the room's admins only. For a caller who may not know of the room the answer is the
/// same as if it did not exist.
void AdminApi::carry_out_in_room(const Call& call) {
  const RoomSettings* settings = registry_.find(call.parameter(0));
  const Claims* claims = call.claims ? &*call.claims : nullptr;
  if (settings == nullptr || !may_know_of(*settings, claims))
    return call.respond(error_answer(no_such_room()));
  if (!call.is_admin_of(settings->name)) return call.respond(not_yours());
  switch (call.match.route.call) {
    case AdminCall::kChangeRoom:
      return change_room(call);
    case AdminCall::kCloseRoom:
      return close_room(call);
    case AdminCall::kListSensors:
      return list_sensors(call);
    case AdminCall::kChangeSensor:
      return change_sensor(call);
    case AdminCall::kEndSensor:
      return end_sensor(call);
    case AdminCall::kListViewers:
      return list_viewers(call);
    case AdminCall::kChangeViewer:
      return change_viewer(call);
    case AdminCall::kEndViewer:
      return end_viewer(call);
    case AdminCall::kListEvents:
      return list_events(call);
    default:
      return carry_out_on_recordings(call);
  }
}

void AdminApi::status(const Call& call) const {
  if (!call.is_hub_admin()) return call.respond(not_yours());
  std::size_t sensors = 0, viewers = 0;
  for (const RoomStats& stats : registry_.stats()) {
    sensors += static_cast<std::size_t>(std::ranges::count_if(stats.sensors, &SensorStats::online));
    viewers += stats.viewers.size();
  }
  const double uptime_s = std::chrono::duration<double>(clock_.now() - started_).count();
  call.respond(json_answer(200, {{"version", version_},
                                 {"uptime_s", uptime_s},
                                 {"rooms", registry_.room_count()},
                                 {"sensors", sensors},
                                 {"viewers", viewers}}));
}

// ---- rooms

void AdminApi::list_hubs(const Call& call) const {
  if (!call.is_hub_admin()) return call.respond(not_yours());
  Json hubs = Json::array();
  for (const HubStatus& hub : registry_.hubs()) {
    Json rooms = Json::array();
    for (const auto& room : hub.rooms) {
      rooms.push_back({{"name", room.name}, {"sensors", room.sensors}, {"viewers", room.viewers}});
    }
    hubs.push_back(
        {{"id", hub.id}, {"url", hub.public_url}, {"load", hub.load}, {"rooms", std::move(rooms)}});
  }
  call.respond(json_answer(200, {{"hubs", std::move(hubs)}}));
}

void AdminApi::list_rooms(const Call& call) const {
  Json rooms = Json::array();
  const Claims* claims = call.claims ? &*call.claims : nullptr;
  for (const RoomStats& stats : registry_.stats()) {
    const RoomSettings& settings = *registry_.find(stats.room);
    if (!may_know_of(settings, claims)) continue;
    rooms.push_back(call.is_admin_of(settings.name) ? whole_room(settings, stats)
                                                    : brief_room(settings, stats));
  }
  call.respond(json_answer(200, {{"rooms", std::move(rooms)}}));
}

void AdminApi::room(const Call& call) const {
  const RoomSettings* settings = registry_.find(call.parameter(0));
  const Claims* claims = call.claims ? &*call.claims : nullptr;
  if (settings == nullptr || !may_know_of(*settings, claims))
    return call.respond(error_answer(no_such_room()));
  const RoomStats stats = *registry_.stats(settings->name);
  call.respond(json_answer(200, call.is_admin_of(settings->name) ? whole_room(*settings, stats)
                                                                 : brief_room(*settings, stats)));
}

void AdminApi::open_room(const Call& call) {
  if (!call.is_hub_admin()) return call.respond(not_yours());
  const auto json = object_in(call.body);
  if (!json) return call.respond(no_object());
  if (!json->contains("name")) {
    return call.respond(error_answer(400, "bad_request", "a room needs a name"));
  }
  const auto settings = changed({.send = AccessRule::kToken,
                                 .view = AccessRule::kToken,
                                 .record = AccessRule::kAdmin,
                                 .share = AccessRule::kAdmin},
                                *json);
  if (!settings) return call.respond(error_answer(settings.error()));
  if (registry_.find(settings->name) != nullptr) {
    return call.respond(error_answer(409, "conflict", "there is a room of this name already"));
  }
  keep_room(call, *settings, true);
}

void AdminApi::change_room(const Call& call) {
  const auto json = object_in(call.body);
  if (!json) return call.respond(no_object());
  const RoomSettings& before = *registry_.find(call.parameter(0));
  const auto settings = changed(before, *json);
  if (!settings) return call.respond(error_answer(settings.error()));
  if (settings->name != before.name) {
    return call.respond(error_answer(400, "bad_request", "the name of a room cannot be changed"));
  }
  keep_room(call, *settings, false);
}

void AdminApi::keep_room(const Call& call, const RoomSettings& settings, bool is_new) {
  store_worker_.ask(
      [settings](HubStore& store) { return store.rooms().save(settings); },
      [this, call, settings, is_new](const Status& kept) {
        if (!kept) return call.respond(error_answer(kept.error()));
        const bool is_there = registry_.find(settings.name) != nullptr;
        if (!is_there && !is_new) return call.respond(error_answer(no_such_room()));
        if (is_there) {
          const std::string fields = fields_that_differ(*registry_.find(settings.name), settings);
          if (!fields.empty()) note(call, "changed_room", settings.name, fields);
          registry_.change(settings);
        } else {
          registry_.open(settings, {});
        }
        call.respond(
            json_answer(is_new ? 201 : 200, whole_room(settings, *registry_.stats(settings.name))));
      });
}

void AdminApi::close_room(const Call& call) {
  if (!call.is_hub_admin()) return call.respond(not_yours());
  if (registry_.is_configured(call.parameter(0))) {
    return call.respond(error_answer(409, "conflict",
                                     "this room is in the hub's configuration and would be opened "
                                     "again at the next start; remove it "
                                     "from the configuration"));
  }
  store_worker_.ask([name = call.parameter(0)](HubStore& store) { return store.forget_room(name); },
                    [this, call](const Status& forgotten) {
                      if (!forgotten) return call.respond(error_answer(forgotten.error()));
                      if (registry_.find(call.parameter(0)) != nullptr)
                        registry_.close(call.parameter(0));
                      registry_.send_revoked();
                      call.respond(no_content());
                    });
}

// ---- sensors of a room

void AdminApi::list_sensors(const Call& call) const {
  Json sensors = Json::array();
  const RoomStats stats = *registry_.stats(call.parameter(0));
  for (const SensorStats& sensor : stats.sensors) {
    sensors.push_back(sensor_json(sensor, registry_.address_of(sensor.connection)));
  }
  call.respond(json_answer(200, {{"sensors", std::move(sensors)}}));
}

void AdminApi::end_sensor(const Call& call) {
  const RoomStats stats = *registry_.stats(call.parameter(0));
  const auto found = std::ranges::find(stats.sensors, call.parameter(1), &SensorStats::name);
  if (found == stats.sensors.end() || !found->online) return forget_sensor(call);
  note(call, "ended", found->name);
  registry_.disconnect_client(found->connection, "the room's owner ended this connection");
  call.respond(no_content());
}

/// The store has all sensors that ever joined, so its answer shows whether this one did. The room
/// forgets first, so that a pending save of the sensor runs before it is deleted from the store.
void AdminApi::forget_sensor(const Call& call) {
  const std::string &room = call.parameter(0), &sensor = call.parameter(1);
  registry_.forget_sensor(room, sensor);
  store_worker_.ask(
      [room, sensor](HubStore& store) { return store.sensors().forget(room, sensor); },
      [this, call, sensor](const Status& forgotten) {
        if (forgotten) note(call, "forgot_sensor", sensor);
        call.respond(forgotten ? no_content() : error_answer(forgotten.error()));
      });
}

// ---- tokens

void AdminApi::list_tokens(const Call& call) {
  if (call.claims->grant.role != TokenRole::kAdmin) return call.respond(not_yours());
  store_worker_.ask(
      [room = call.claims->grant.room](HubStore& store) { return store.tokens(room); },
      [call](const Result<std::vector<IssuedToken>>& tokens) {
        if (!tokens) return call.respond(error_answer(tokens.error()));
        Json list = Json::array();
        for (const IssuedToken& token : *tokens) list.push_back(token_json(token));
        call.respond(json_answer(200, {{"tokens", std::move(list)}}));
      });
}

void AdminApi::make_token(const Call& call) {
  const auto json = object_in(call.body);
  if (!json) return call.respond(no_object());
  const auto wanted = read_token_request(*json);
  if (!wanted) return call.respond(error_answer(wanted.error()));
  if (!call.is_admin_of(wanted->grant.room)) return call.respond(not_yours());
  store_worker_.ask([wanted = *wanted](HubStore& store) { return make_token_for(wanted, store); },
                    [call](const Result<Json>& made) {
                      call.respond(made ? json_answer(201, *made) : error_answer(made.error()));
                    });
}

void AdminApi::revoke_token(const Call& call) {
  if (call.claims->grant.role != TokenRole::kAdmin) return call.respond(not_yours());
  const std::string& id = call.parameter(0);
  store_worker_.ask(
      [id, grant = call.claims->grant](HubStore& store) -> Status {
        const auto token = store.token(id);
        if (!token) return token.error();
        if (!covers(grant, token->claims.grant.room)) {  // another room's: as if there were none
          return Error{ErrorCode::kNotFound, "this hub has issued no token \"" + id + "\""};
        }
        return store.revoke(id);
      },
      [this, call, id](const Status& revoked) {
        if (!revoked) return call.respond(error_answer(revoked.error()));
        registry_.disconnect_token_holders({id});
        registry_.send_revoked();
        call.respond(no_content());
      });
}

}  // namespace roomcast::hub
