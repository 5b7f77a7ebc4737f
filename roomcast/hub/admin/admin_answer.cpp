// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/admin/admin_answer.h"

#include <algorithm>
#include <memory>

#include "roomcast/geometry/sensor_pose.h"
#include "roomcast/hub/admin/sensor_settings_json.h"

namespace roomcast::hub {

namespace {

using Json = nlohmann::json;
namespace pb = wire::pb;

struct Named {
  int status;
  const char* code;
};

Named named(pb::ErrorCode code) {
  switch (code) {
    case pb::ERROR_UNAUTHENTICATED:
      return {401, "unauthenticated"};
    case pb::ERROR_TOKEN_EXPIRED:
      return {401, "expired"};
    case pb::ERROR_TOKEN_INVALID:
      return {401, "invalid_token"};
    case pb::ERROR_TOKEN_REVOKED:
      return {401, "revoked"};
    case pb::ERROR_WRONG_ROOM:
      return {403, "wrong_room"};
    case pb::ERROR_WRONG_ROLE:
      return {403, "wrong_role"};
    case pb::ERROR_NO_SUCH_ROOM:
      return {404, "not_found"};
    default:
      return {503, "unavailable"};
  }
}

Named named(ErrorCode code) {
  switch (code) {
    case ErrorCode::kNotFound:
      return {404, "not_found"};
    case ErrorCode::kInvalidArgument:
    case ErrorCode::kMalformed:
      return {400, "bad_request"};
    case ErrorCode::kTooLarge:
      return {413, "too_large"};
    default:
      return {503, "unavailable"};
  }
}

const char* placement_name(const SensorPose& pose) {
  if (pose.source == PoseSource::kGiven) return "given";
  return pose.is_estimated() ? "aligned" : "unplaced";
}

void count_people(const RoomStats& stats, Json& json) {
  json["sensors"] = std::ranges::count_if(stats.sensors, &SensorStats::online);
  json["viewers"] = stats.viewers.size();
}

}  // namespace

net::HttpResponse json_answer(int status, const Json& body) {
  net::HttpResponse response =
      net::text_response(status, body.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
  response.content_type = "application/json";
  return response;
}

net::HttpResponse no_content() {
  return net::text_response(204, "");
}

net::HttpResponse error_answer(int status, std::string_view code, const std::string& sentence) {
  return json_answer(status, {{"error", {{"code", code}, {"sentence", sentence}}}});
}

net::HttpResponse error_answer(const Refusal& why) {
  const Named name = named(why.code);
  auto response = error_answer(name.status, name.code, why.sentence);
  if (name.status == 401) response.headers = {{"WWW-Authenticate", "Bearer"}};
  return response;
}

net::HttpResponse error_answer(const Error& error) {
  const Named name = named(error.code);
  return error_answer(name.status, name.code, error.message);
}

Json brief_room(const RoomSettings& settings, const RoomStats& stats) {
  Json json = {{"name", settings.name},
               {"title", settings.title.empty() ? settings.name : settings.title},
               {"max_viewers", settings.max_viewers},
               {"view", name_of(settings.view)},
               {"record", name_of(settings.record)},
               {"export", name_of(settings.share)},
               {"speak", name_of(settings.speak)}};
  count_people(stats, json);
  return json;
}

Json whole_room(const RoomSettings& settings, const RoomStats& stats) {
  Json json = to_json(settings);
  count_people(stats, json);
  json["frames_wanted"] = stats.frames_wanted;
  return json;
}

Json sensor_json(const SensorStats& sensor, const std::string& address) {
  Json json = {{"id", sensor.id.value},
               {"name", sensor.name},
               {"online", sensor.online},
               {"frames", sensor.frames},
               {"bytes", sensor.bytes},
               {"frames_per_second", sensor.frames_per_s},
               {"bytes_per_second", sensor.bytes_per_s},
               {"unseen", sensor.is_unseen},
               {"share_mbit", sensor.share_mbit},
               {"delay_ms", sensor.delay_s * 1000},
               {"placement", placement_name(sensor.pose)},
               {"placement_note", sensor.pose.note},
               {"moved", sensor.pose.is_moved()},
               {"unverified", sensor.pose.source == PoseSource::kStored},
               {"expected_error_mm", sensor.pose.expected_error_mm},
               {"depth_scale", sensor.pose.depth_scale},
               {"has_microphone", sensor.has_microphone},
               {"speaks", sensor.speaks},
               {"muted", sensor.muted},
               {"world_from_depth", row_major_from_transform(sensor.pose.world_from_depth)}};
  if (sensor.interference) {
    const SensorInterference& disturbed = *sensor.interference;
    json["interference"] = {{"flickering", disturbed.flickering},
                            {"noise_ratio", disturbed.noise_ratio},
                            {"neighbour", disturbed.neighbour},
                            {"shared", disturbed.shared},
                            {"advice", disturbed.advice}};
  }
  if (sensor.settings) json["settings"] = to_json(*sensor.settings);
  if (sensor.clock_error_s) json["clock_error_ms"] = *sensor.clock_error_s * 1000;
  if (!address.empty()) json["address"] = address;
  if (!sensor.token_id.empty()) json["token_id"] = sensor.token_id;
  return json;
}

Json viewer_json(const ViewerStats& viewer, const std::string& address) {
  Json json = {{"id", viewer.id.value},
               {"name", viewer.name},
               {"records", viewer.records},
               {"may_speak", viewer.may_speak},
               {"speaks", viewer.speaks},
               {"muted", viewer.muted},
               {"bytes", viewer.bytes},
               {"bytes_per_second", viewer.bytes_per_s},
               {"sets_dropped", viewer.dropped_sets},
               {"audio_packets_dropped", viewer.dropped_audio},
               {"small_sensors", viewer.small_sensors},
               {"shown_fps", viewer.shown_fps},
               {"latency_ms", viewer.latency_ms}};
  if (!viewer.plays.empty()) json["plays"] = viewer.plays;
  if (!address.empty()) json["address"] = address;
  if (!viewer.token_id.empty()) json["token_id"] = viewer.token_id;
  return json;
}

nlohmann::json recording_json(const RoomRecording& recording) {
  nlohmann::json json = {{"state", name_of(recording.state)},
                         {"seconds", recording.seconds},
                         {"frames", recording.frames},
                         {"bytes", recording.bytes}};
  if (!recording.file.empty()) json["file"] = recording.file;
  if (!recording.problem.empty()) json["problem"] = recording.problem;
  return json;
}

Json kept_recording_json(const KeptRecording& recording) {
  Json json = {{"name", recording.name},         {"state", name_of(recording.state)},
               {"bytes", recording.bytes},       {"seconds", recording.seconds},
               {"began_at", recording.began_at}, {"sensors", recording.sensors},
               {"voices", recording.has_voices}};
  if (!recording.by.empty()) json["by"] = recording.by;
  if (!recording.problem.empty()) json["problem"] = recording.problem;
  return json;
}

Json token_json(const IssuedToken& token) {
  return {{"id", token.claims.id},
          {"room", token.claims.grant.room},
          {"role", name_of(token.claims.grant.role)},
          {"name", token.claims.grant.name},
          {"issued_at", token.claims.issued_at},
          {"expires_at", token.claims.expires_at},
          {"revoked", token.revoked},
          {"once", token.is_code}};
}

}  // namespace roomcast::hub
