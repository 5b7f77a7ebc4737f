// SPDX-License-Identifier: Apache-2.0
// The AdminApi's calls about a room's recordings: the running one, and the files.
#include <cstdint>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "roomcast/hub/admin/admin_answer.h"
#include "roomcast/hub/admin/admin_api.h"
#include "roomcast/hub/admin/path_number.h"
#include "roomcast/hub/admin/watcher_json.h"
#include "roomcast/net/http_request.h"

namespace roomcast::hub {

namespace {

net::HttpResponse keeps_no_recordings() {
  return error_answer(409, "conflict", "this hub has no folder for recordings");
}

net::HttpResponse refusal_of(const Error& error) {
  if (error.code == ErrorCode::kUnavailable) return error_answer(409, "conflict", error.message);
  return error_answer(error);
}

/// {"name": "..."}; nothing: the body is something else.
std::optional<std::string> name_in(const std::string& body) {
  const auto json = nlohmann::json::parse(body, nullptr, false);
  if (!json.is_object() || json.size() != 1) return std::nullopt;
  const auto name = json.find("name");
  if (name == json.end() || !name->is_string()) return std::nullopt;
  return name->get<std::string>();
}

/// Files that do not say their room are shown to admins of the whole hub only.
RecordingScope scope_of(const Caller& caller, const std::string& room) {
  return {.room = room, .unknown_too = caller.is_hub_admin()};
}

using OpenedFile = Result<std::shared_ptr<const net::LongBody>>;

net::HttpResponse file_answer(const OpenedFile& file, const std::string& name) {
  if (!file) return refusal_of(file.error());
  net::HttpResponse response;
  response.content_type = "application/octet-stream";
  response.long_body = *file;
  response.cache_control = "no-store";
  response.headers = {{"Content-Disposition",
                       "attachment; filename*=UTF-8''" + net::percent_encoded(name + ".mcap")}};
  return response;
}

}  // namespace

void AdminApi::carry_out_on_recordings(const Call& call) {
  if (call.match.route.call == AdminCall::kRecording) return recording(call);
  if (recordings_ == nullptr) return call.respond(keeps_no_recordings());
  switch (call.match.route.call) {
    case AdminCall::kStartRecording:
      return start_recording(call);
    case AdminCall::kStopRecording:
      return stop_recording(call);
    case AdminCall::kListRecordings:
      return list_recordings(call);
    case AdminCall::kAboutRecording:
      return about_recording(call);
    case AdminCall::kRecordingMoment:
    case AdminCall::kRecordingPart:
    case AdminCall::kRecordingKeyFrame:
      return recording_part(call);
    case AdminCall::kRecordingFile:
      return recording_file(call);
    case AdminCall::kWatchTogether:
      return watch_together(call);
    case AdminCall::kMakeDownload:
      return make_download(call);
    case AdminCall::kRenameRecording:
      return rename_recording(call);
    default:
      return delete_recording(call);
  }
}

void AdminApi::recording(const Call& call) const {
  const std::string& room = call.parameter(0);
  const RoomRecording now = recordings_ == nullptr ? RoomRecording{} : recordings_->now(room);
  call.respond(json_answer(200, recording_json(now)));
}

void AdminApi::start_recording(const Call& call) {
  const std::string& room = call.parameter(0);
  if (registry_.find(room)->record == AccessRule::kNobody) {
    return call.respond(
        error_answer(403, "wrong_role", "the settings of this room forbid recording"));
  }
  if (!recordings_->start(room, call.claims->grant.name)) {
    return call.respond(error_answer(409, "conflict", "this room is being recorded already"));
  }
  note(call, "recording_started");
  call.respond(json_answer(201, recording_json(recordings_->now(room))));
}

void AdminApi::stop_recording(const Call& call) {
  const std::string& room = call.parameter(0);
  if (!recordings_->stop(room)) {
    return call.respond(error_answer(409, "conflict", "this room is not being recorded"));
  }
  note(call, "recording_stopped");
  call.respond(json_answer(200, recording_json(recordings_->now(room))));
}

void AdminApi::list_recordings(const Call& call) const {
  recordings_->kept().list(scope_of(call, call.parameter(0)),
                           [call](const Result<RecordingList>& list) {
                             if (!list) return call.respond(refusal_of(list.error()));
                             nlohmann::json recordings = nlohmann::json::array();
                             for (const KeptRecording& kept : list->recordings)
                               recordings.push_back(kept_recording_json(kept));
                             call.respond(json_answer(200, {{"recordings", std::move(recordings)},
                                                            {"left_out", list->left_out},
                                                            {"unread", list->unread}}));
                           });
}

void AdminApi::about_recording(const Call& call) const {
  recordings_->kept().about(scope_of(call, call.parameter(0)), call.parameter(1),
                            [call](const Result<KeptRecording>& found) {
                              call.respond(found ? json_answer(200, kept_recording_json(*found))
                                                 : refusal_of(found.error()));
                            });
}

void AdminApi::recording_part(const Call& call) const {
  using Kind = WantedPart::Kind;
  const AdminCall asked = call.match.route.call;
  const bool is_key_frame = asked == AdminCall::kRecordingKeyFrame;
  const auto number = path_number<std::uint32_t>(call.match.parameters.back());
  if (!number)
    return call.respond(error_answer(400, "bad_request", "the address must end with a number"));
  recordings_->kept().part(scope_of(call, call.parameter(0)), call.parameter(1),
                           {.kind = is_key_frame                           ? Kind::kKeyFrame
                                    : asked == AdminCall::kRecordingMoment ? Kind::kMoment
                                                                           : Kind::kPart,
                            .number = *number,
                            .sensor = is_key_frame ? call.parameter(2) : ""},
                           [call](const Result<std::shared_ptr<const std::string>>& part) {
                             if (!part) return call.respond(refusal_of(part.error()));
                             net::HttpResponse response;
                             response.content_type = "application/octet-stream";
                             response.body = *part;
                             response.cache_control = "no-store";
                             call.respond(std::move(response));
                           });
}

void AdminApi::recording_file(const Call& call) const {
  const std::string& name = call.parameter(1);
  recordings_->kept().open(
      scope_of(call, call.parameter(0)), name,
      [call, name](const OpenedFile& file) { call.respond(file_answer(file, name)); });
}

void AdminApi::rename_recording(const Call& call) const {
  auto name = name_in(call.body);
  if (!name)
    return call.respond(
        error_answer(400, "bad_request", R"(the body must be {"name": "the new name"})"));
  recordings_->kept().rename(scope_of(call, call.parameter(0)), call.parameter(1), *std::move(name),
                             [call](const Result<KeptRecording>& renamed) {
                               call.respond(renamed
                                                ? json_answer(200, kept_recording_json(*renamed))
                                                : refusal_of(renamed.error()));
                             });
}

void AdminApi::delete_recording(const Call& call) const {
  recordings_->kept().remove(scope_of(call, call.parameter(0)), call.parameter(1),
                             [call](const Status& removed) {
                               call.respond(removed ? no_content() : refusal_of(removed.error()));
                             });
}

void AdminApi::watch_together(const Call& call) {
  const auto watcher = read_watcher(call.body);
  if (!watcher) return call.respond(error_answer(watcher.error()));
  const auto view =
      parties_.visit(call.parameter(0) + "/" + call.parameter(1), *watcher, clock_.now());
  if (!view) {
    return call.respond(
        error_answer(409, "conflict", "as many people as may are playing recordings together"));
  }
  call.respond(json_answer(200, watch_party_json(*view)));
}

void AdminApi::make_download(const Call& call) {
  DownloadLinks::File file{scope_of(call, call.parameter(0)), call.parameter(1)};
  std::string key = downloads_.make(file, clock_.now());
  recordings_->kept().open(file.scope, file.name, [call, key](const OpenedFile& opened) {
    if (!opened) return call.respond(refusal_of(opened.error()));
    call.respond(json_answer(201, {{"address", "downloads/" + key},
                                   {"bytes", (*opened)->size()},
                                   {"valid_s", DownloadLinks::kValid.count()}}));
  });
}

void AdminApi::download(const Call& call) {
  const auto file = downloads_.take(call.parameter(0), clock_.now());
  if (!file || recordings_ == nullptr) {
    return call.respond(
        error_answer(404, "not_found", "this download was used or is too old; ask for it again"));
  }
  recordings_->kept().open(file->scope, file->name,
                           [call, name = file->name](const OpenedFile& opened) {
                             call.respond(file_answer(opened, name));
                           });
}

}  // namespace roomcast::hub
