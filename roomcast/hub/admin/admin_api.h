// SPDX-License-Identifier: Apache-2.0
// AdminApi: answers the hub's HTTP interface for operators (docs/spec/admin.openapi.yaml). A change
// is written to disk before it takes effect, and takes effect before it is acknowledged. Threading:
// the rooms' thread; answers come later, on that thread.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "roomcast/core/clock.h"
#include "roomcast/hub/admin/admin_auth.h"
#include "roomcast/hub/admin/admin_routes.h"
#include "roomcast/hub/admin/download_links.h"
#include "roomcast/hub/admin/study_api.h"
#include "roomcast/hub/runtime/room_models.h"
#include "roomcast/hub/runtime/room_recordings.h"
#include "roomcast/hub/runtime/room_registry.h"
#include "roomcast/hub/runtime/watch_party.h"
#include "roomcast/hub/store/store_worker.h"
#include "roomcast/net/http_request.h"

namespace roomcast::hub {

class AdminApi {
 public:
  /// `recordings`: null if rooms cannot be recorded. `study`, `models`: null if there are none.
  AdminApi(RoomRegistry& registry, StoreWorker& store_worker, std::string version,
           RoomRecordings* recordings, StudyDesk* study = nullptr, RoomModels* models = nullptr,
           LogSink log = {});

  void answer(const net::HttpRequest& request, net::Respond respond);

 private:
  /// One admitted call with its caller and parameters.
  struct Call : Caller {
    MatchedRoute match;
    std::string body;

    [[nodiscard]] const std::string& parameter(std::size_t i) const { return match.parameters[i]; }
  };

  void apply(const Call& call);
  void answer_participant(const net::HttpRequest& request, const MatchedRoute& match,
                          const net::Respond& respond);
  void carry_out_in_room(const Call& call);
  void status(const Call& call) const;
  void list_hubs(const Call& call) const;
  void list_rooms(const Call& call) const;
  void room(const Call& call) const;
  void room_model(const Call& call) const;
  void open_room(const Call& call);
  void change_room(const Call& call);
  void close_room(const Call& call);
  void keep_room(const Call& call, const RoomSettings& settings, bool is_new);
  void list_sensors(const Call& call) const;
  void change_sensor(const Call& call);
  void mute_sensor(const Call& call);
  void end_sensor(const Call& call);
  void forget_sensor(const Call& call);
  void list_viewers(const Call& call) const;
  void change_viewer(const Call& call);
  void end_viewer(const Call& call);
  [[nodiscard]] std::optional<ViewerStats> viewer_of(const Call& call) const;
  void list_events(const Call& call) const;
  /// Notes what the caller did in the room.
  void note(const Call& call, const char* kind, const std::string& name = "",
            const std::string& sentence = "") const;
  void carry_out_on_recordings(const Call& call);
  void recording(const Call& call) const;
  void start_recording(const Call& call);
  void stop_recording(const Call& call);
  void list_recordings(const Call& call) const;
  void about_recording(const Call& call) const;
  void recording_part(const Call& call) const;
  void recording_file(const Call& call) const;
  void rename_recording(const Call& call) const;
  void delete_recording(const Call& call) const;
  void watch_together(const Call& call);
  void make_download(const Call& call);
  void download(const Call& call);
  void list_tokens(const Call& call);
  void make_token(const Call& call);
  void revoke_token(const Call& call);

  RoomRegistry& registry_;
  StoreWorker& store_worker_;
  const std::string version_;
  RoomRecordings* const recordings_;
  RoomModels* const models_;
  DownloadLinks downloads_;
  WatchParties parties_;
  AdminAuth auth_;
  StudyApi study_;
  SteadyClock clock_;
  const HostTime started_ = clock_.now();
};

}  // namespace roomcast::hub
