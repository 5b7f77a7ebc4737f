// SPDX-License-Identifier: Apache-2.0
// HubServer: serves rooms on a port. The rooms' state and timers are on the thread that calls
// run(). Connections are distributed over that thread and others (Shard). One more thread accesses
// the store (StoreWorker), and a low-priority one accepts connections and serves HTTP. Threading:
// open() and run() on one thread; the other members on any thread.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "roomcast/core/log.h"
#include "roomcast/core/result.h"
#include "roomcast/hub/access/ban_list.h"
#include "roomcast/hub/access/claims.h"
#include "roomcast/hub/config/room_settings.h"
#include "roomcast/hub/runtime/backplane.h"
#include "roomcast/hub/runtime/room_models.h"
#include "roomcast/hub/runtime/room_recordings.h"
#include "roomcast/hub/runtime/session.h"
#include "roomcast/hub/runtime/study_desk.h"
#include "roomcast/net/allowed_names.h"
#include "roomcast/net/tls/tls_context.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub {

/// Limits against abuse.
struct HubLimits {
  std::size_t max_connections = 4096;                        // HTTP and WebSockets
  std::size_t max_unjoined = wire::kMaxUnjoinedConnections;  // WebSockets, over all addresses
  std::size_t max_unsettled_per_peer = 64;  // connections of one address that are in no room
  BanRules bans = {};
  SessionLimits session = {};
  std::vector<std::string> proxies = {"127.0.0.1", "::1"};  // no per-address limit, no bans
};

struct HubOptions {
  std::string address = "127.0.0.1";
  std::uint16_t port = 7600;                              // 0: any free one
  std::shared_ptr<const net::TlsServerContext> tls = {};  // null: no encryption
  /// The configured rooms. Rooms that admins opened are added; settings that admins changed take
  /// precedence.
  std::vector<RoomSettings> rooms = {RoomSettings{}};
  /// Folder for rooms, tokens, sensor IDs and poses; without it they are lost when the hub ends.
  std::optional<std::filesystem::path> data_folder = {};
  bool restores_poses = true;  // restore estimated poses; only where an aligner verifies them
  std::optional<std::filesystem::path> web_directory =
      {};  // the page to serve; without it "/" explains how to get one
  net::AllowedNames names = {};
  bool metrics_for_anyone = true;  // false: `/metrics` requires an admin's token
  std::chrono::milliseconds join_within = wire::kJoinDeadline;
  HubLimits limits = {};
  std::size_t threads = 1;  // at least 1; more than the number of cores gain nothing
  /// A room's first sensor has joined. Called on the rooms' thread.
  std::function<void(const std::string& room)> on_room_in_use = {};
  std::shared_ptr<RoomRecordings> recordings = {};  // null: rooms cannot be recorded
  std::shared_ptr<StudyDesk> study = {};            // null: this hub runs no study
  std::shared_ptr<RoomModels> models = {};          // null: no room's model is kept
  OpenBackplane open_backplane = {};                // connects to other hubs; empty: there are none
  std::optional<Grant> first_link = {};             // makes link_fragment() a link with this grant
  LogSink log = {};                                 // called from all threads
};

class HubServer {
 public:
  /// Listens at once; clients are served once run() runs. kUnavailable: the port is in use, or the
  /// store cannot be opened. kInvalidArgument: an invalid address, room or grant. kNotFound: no
  /// page in the web directory. Also the errors of open_backplane.
  static Result<std::unique_ptr<HubServer>> open(HubOptions options);
  ~HubServer();

  [[nodiscard]] std::uint16_t port() const;

  /// An admin token for helpers in this process; valid for all rooms while the hub runs.
  [[nodiscard]] const std::string& own_token() const;

  /// "#code=...", to be appended to the page's address: a one-time code for the grant of
  /// `first_link`, to be used within HubStore::kCodeTtl. Its token is valid for a day. Empty: no
  /// link was asked for.
  [[nodiscard]] const std::string& link_fragment() const;

  /// Replaces the certificate for new connections. Only for a hub that was opened with TLS.
  void replace_tls(std::shared_ptr<const net::TlsServerContext> tls);

  /// Serves until `stop` is requested, then closes all connections cleanly.
  void run(std::stop_token stop);

 private:
  class Loop;
  explicit HubServer(std::unique_ptr<Loop> loop);
  std::unique_ptr<Loop> loop_;
};

}  // namespace roomcast::hub
