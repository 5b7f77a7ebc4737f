// SPDX-License-Identifier: Apache-2.0
// HubPages: a hub's HTTP answers: the page, `/healthz`, `/metrics` and the admin interface.
// Threading: find() on the thread that accepts connections; answer() on any thread, it posts to the
// rooms' thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <boost/asio/io_context.hpp>

#include "roomcast/hub/admin/admin_api.h"
#include "roomcast/hub/admin/admin_auth.h"
#include "roomcast/hub/runtime/room_registry.h"
#include "roomcast/hub/server/peer_origins.h"
#include "roomcast/hub/store/store_worker.h"
#include "roomcast/net/http_request.h"
#include "roomcast/net/http_server.h"
#include "roomcast/net/static_site.h"

namespace roomcast::hub {

class HubPages {
 public:
  HubPages(std::optional<net::StaticSite> site, RoomRegistry& registry, StoreWorker& store_worker,
           boost::asio::io_context& rooms_io, bool metrics_for_anyone, std::string version,
           RoomRecordings* recordings, StudyDesk* study, RoomModels* models, const LogSink& log);

  /// Sets the server whose connections `/metrics` counts.
  void count_connections_of(const net::HttpServer& server) { server_ = &server; }

  /// The path prefixes that go to answer().
  [[nodiscard]] static std::vector<std::string> request_paths();

  /// The page can be shown in a frame by the sites that the room in its query allows, and its
  /// address must name the room for that: a page may join no other room than its address says.
  [[nodiscard]] std::optional<net::HttpResponse> find(std::string_view path,
                                                      std::string_view query) const;
  /// The other hubs that pages may reach. Same thread as find().
  [[nodiscard]] PeerOrigins& peer_origins() { return peer_origins_; }
  void answer(net::HttpRequest request, net::Respond respond);

 private:
  void answer_here(const net::HttpRequest& request, net::Respond respond);
  [[nodiscard]] net::HttpResponse health() const;
  [[nodiscard]] net::HttpResponse metrics() const;

  const std::optional<net::StaticSite> site_;
  RoomRegistry& registry_;
  boost::asio::io_context& rooms_io_;
  const bool metrics_for_anyone_;
  const std::string version_;
  AdminAuth accept_io_;
  AdminApi admin_;
  const net::HttpServer* server_ = nullptr;
  PeerOrigins peer_origins_;
};

}  // namespace roomcast::hub
