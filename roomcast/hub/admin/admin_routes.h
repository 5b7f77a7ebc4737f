// SPDX-License-Identifier: Apache-2.0
// The routes of the hub's HTTP interface: method and path of each call. Specified in
// docs/spec/admin.openapi.yaml; a test compares the two. Threading: immutable.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace roomcast::hub {

enum class AdminCall {
  kStatus,
  kListHubs,
  kListRooms,
  kOpenRoom,
  kRoom,
  kChangeRoom,
  kCloseRoom,
  kListSensors,
  kChangeSensor,
  kEndSensor,
  kListViewers,
  kChangeViewer,
  kEndViewer,
  kListEvents,
  kRoomModel,
  kRecording,
  kStartRecording,
  kStopRecording,
  kListRecordings,
  kAboutRecording,
  kRecordingMoment,
  kRecordingPart,
  kRecordingKeyFrame,
  kRecordingFile,
  kMakeDownload,
  kRenameRecording,
  kDeleteRecording,
  kWatchTogether,
  kDownload,
  kListTokens,
  kMakeToken,
  kRevokeToken,
  kStudy,
  kEnroll,
  kResume,
  kLogSession,
  kStudyPicture,
};

struct AdminRoute {
  std::string_view method;  // "GET"
  std::string_view path;    // "/rooms/{room}", below kAdminBase
  AdminCall call;
  bool needs_token = true;
};

inline constexpr std::string_view kAdminBase = "/api/v1";

[[nodiscard]] std::span<const AdminRoute> admin_routes();

struct MatchedRoute {
  AdminRoute route;
  std::vector<std::string> parameters;  // in the order of the path, decoded
};
enum class NoRoute { kUnknownPath, kUnknownMethod };

[[nodiscard]] std::variant<MatchedRoute, NoRoute> match_admin_route(std::string_view method,
                                                                    std::string_view path);

}  // namespace roomcast::hub
