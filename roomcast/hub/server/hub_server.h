// SPDX-License-Identifier: Apache-2.0
// HubServer: rooms on a port. The rooms' state and timers live on the thread that runs it; its
// connections are dealt out among that one and others (Shard); what it keeps is in the care of one
// more (StoreWorker). Threading: open() and run() on one thread; the rest from any.
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
#include "roomcast/hub/config/room_settings.h"
#include "roomcast/hub/runtime/backplane.h"
#include "roomcast/hub/runtime/room_recordings.h"
#include "roomcast/hub/runtime/session.h"
#include "roomcast/net/allowed_names.h"
#include "roomcast/net/tls/tls_context.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub {

/// Against those who want to be a burden.
struct HubLimits {
  std::size_t max_connections = 4096;                        // of all kinds
  std::size_t max_unjoined = wire::kMaxUnjoinedConnections;  // WebSockets, over all addresses
  std::size_t max_unsettled_per_peer = 64;  // connections of one address that are in no room
  BanRules bans = {};
  SessionLimits session = {};
  std::vector<std::string> proxies = {"127.0.0.1", "::1"};  // neither counted nor banned
};

struct HubOptions {
  std::string address = "127.0.0.1";
  std::uint16_t port = 7600;                              // 0: any free one
  std::shared_ptr<const net::TlsServerContext> tls = {};  // without it nothing is encrypted
  /// Those that admins opened are there besides, and what they changed holds.
  std::vector<RoomSettings> rooms = {RoomSettings{}};
  /// Where rooms, tokens, sensors' ids and poses are kept; without it they are forgotten.
  std::optional<std::filesystem::path> data_folder = {};
  bool recalls_poses = true;  // of sensors that were here before; only where an aligner verifies
  std::optional<std::filesystem::path> web_directory =
      {};  // the page to serve; without it "/" says how to get one
  net::AllowedNames names = {};
  bool metrics_for_anyone = true;  // else `/metrics` takes an admin's token
  std::chrono::milliseconds join_within = wire::kJoinDeadline;
  HubLimits limits = {};
  std::size_t threads = 1;  // at least 1; more than cores gain nothing
  /// A room's first sensor has joined. On the rooms' thread.
  std::function<void(const std::string& room)> on_room_in_use = {};
  std::shared_ptr<RoomRecordings> recordings = {};  // null: rooms are not kept
  OpenBackplane open_backplane = {};                // to other hubs; without it there are none
  LogSink log = {};                                 // called from all threads
};

class HubServer {
 public:
  /// Listens at once; clients are served once run() runs. kUnavailable: the port is in use, or what
  /// the hub keeps cannot be opened. kInvalidArgument: not an address, or a room that cannot be.
  /// kNotFound: no page in the web directory. And why there is no backplane.
  static Result<std::unique_ptr<HubServer>> open(HubOptions options);
  ~HubServer();

  [[nodiscard]] std::uint16_t port() const;

  /// For helpers in this process: good for everything in this hub, for as long as it runs.
  [[nodiscard]] const std::string& own_token() const;

  /// For connections from now on. Only where there was TLS from the start.
  void replace_tls(std::shared_ptr<const net::TlsServerContext> tls);

  /// Serves until `stop` is requested, then closes all connections in good order.
  void run(std::stop_token stop);

 private:
  class Loop;
  explicit HubServer(std::unique_ptr<Loop> loop);
  std::unique_ptr<Loop> loop_;
};

}  // namespace roomcast::hub
