// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/admin/admin_routes.h"

#include <array>

#include "roomcast/net/http_request.h"

namespace roomcast::hub {

namespace {

constexpr std::array kRoutes = {
    AdminRoute{"GET", "/status", AdminCall::kStatus},
    AdminRoute{"GET", "/hubs", AdminCall::kListHubs},
    AdminRoute{"GET", "/rooms", AdminCall::kListRooms, false},
    AdminRoute{"POST", "/rooms", AdminCall::kOpenRoom},
    AdminRoute{"GET", "/rooms/{room}", AdminCall::kRoom, false},
    AdminRoute{"PATCH", "/rooms/{room}", AdminCall::kChangeRoom},
    AdminRoute{"DELETE", "/rooms/{room}", AdminCall::kCloseRoom},
    AdminRoute{"GET", "/rooms/{room}/sensors", AdminCall::kListSensors},
    AdminRoute{"PATCH", "/rooms/{room}/sensors/{sensor}", AdminCall::kChangeSensor},
    AdminRoute{"DELETE", "/rooms/{room}/sensors/{sensor}", AdminCall::kEndSensor},
    AdminRoute{"GET", "/rooms/{room}/viewers", AdminCall::kListViewers},
    AdminRoute{"PATCH", "/rooms/{room}/viewers/{viewer}", AdminCall::kChangeViewer},
    AdminRoute{"DELETE", "/rooms/{room}/viewers/{viewer}", AdminCall::kEndViewer},
    AdminRoute{"GET", "/rooms/{room}/events", AdminCall::kListEvents},
    AdminRoute{"GET", "/rooms/{room}/events/after/{event}", AdminCall::kListEvents},
    AdminRoute{"GET", "/rooms/{room}/model", AdminCall::kRoomModel, false},
    AdminRoute{"GET", "/rooms/{room}/model/after/{version}", AdminCall::kRoomModel, false},
    AdminRoute{"GET", "/rooms/{room}/recording", AdminCall::kRecording},
    AdminRoute{"POST", "/rooms/{room}/recording", AdminCall::kStartRecording},
    AdminRoute{"DELETE", "/rooms/{room}/recording", AdminCall::kStopRecording},
    AdminRoute{"GET", "/rooms/{room}/recordings", AdminCall::kListRecordings},
    AdminRoute{"GET", "/rooms/{room}/recordings/{recording}", AdminCall::kAboutRecording},
    AdminRoute{"GET", "/rooms/{room}/recordings/{recording}/moments/{ms}",
               AdminCall::kRecordingMoment},
    AdminRoute{"GET", "/rooms/{room}/recordings/{recording}/parts/{part}",
               AdminCall::kRecordingPart},
    AdminRoute{"GET", "/rooms/{room}/recordings/{recording}/sensors/{sensor}/key-frames/{ms}",
               AdminCall::kRecordingKeyFrame},
    AdminRoute{"POST", "/rooms/{room}/recordings/{recording}/together", AdminCall::kWatchTogether},
    AdminRoute{"PATCH", "/rooms/{room}/recordings/{recording}", AdminCall::kRenameRecording},
    AdminRoute{"DELETE", "/rooms/{room}/recordings/{recording}", AdminCall::kDeleteRecording},
    AdminRoute{"GET", "/rooms/{room}/recordings/{recording}/file", AdminCall::kRecordingFile},
    AdminRoute{"POST", "/rooms/{room}/recordings/{recording}/download", AdminCall::kMakeDownload},
    AdminRoute{"GET", "/downloads/{download}", AdminCall::kDownload, false},
    AdminRoute{"GET", "/tokens", AdminCall::kListTokens},
    AdminRoute{"POST", "/tokens", AdminCall::kMakeToken},
    AdminRoute{"DELETE", "/tokens/{id}", AdminCall::kRevokeToken},
    AdminRoute{"GET", "/study", AdminCall::kStudy, false},
    AdminRoute{"POST", "/study/participants", AdminCall::kEnroll, false},
    AdminRoute{"POST", "/study/participants/{participant}/resume", AdminCall::kResume, false},
    AdminRoute{"POST", "/study/participants/{participant}/log", AdminCall::kLogSession, false},
    AdminRoute{"POST", "/study/participants/{participant}/picture", AdminCall::kStudyPicture,
               false},
};

/// Removes "/x" from the front of "/x/y" and returns it.
std::string_view take_segment(std::string_view& path) {
  const auto end = path.find('/', 1);
  const std::string_view segment = path.substr(0, end);
  path.remove_prefix(segment.size());
  return segment;
}

/// The parameters in `path`; nothing: it does not match `pattern`.
std::optional<std::vector<std::string>> match(std::string_view pattern, std::string_view path) {
  std::vector<std::string> parameters;
  while (!pattern.empty() && !path.empty()) {
    const std::string_view wanted = take_segment(pattern), found = take_segment(path);
    if (wanted.starts_with("/{") && found.size() > 1) {
      parameters.push_back(net::percent_decoded(found.substr(1)));
    } else if (wanted != found) {
      return std::nullopt;
    }
  }
  if (!pattern.empty() || !path.empty()) return std::nullopt;
  return parameters;
}

}  // namespace

std::span<const AdminRoute> admin_routes() {
  return kRoutes;
}

std::variant<MatchedRoute, NoRoute> match_admin_route(std::string_view method,
                                                      std::string_view path) {
  if (!path.starts_with(kAdminBase)) return NoRoute::kUnknownPath;
  path.remove_prefix(kAdminBase.size());
  NoRoute reason = NoRoute::kUnknownPath;
  for (const AdminRoute& route : kRoutes) {
    auto parameters = match(route.path, path);
    if (!parameters) continue;
    if (route.method == method) return MatchedRoute{route, *std::move(parameters)};
    reason = NoRoute::kUnknownMethod;
  }
  return reason;
}

}  // namespace roomcast::hub
