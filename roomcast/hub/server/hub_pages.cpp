// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/server/hub_pages.h"

#include <algorithm>
#include <utility>

#include <boost/asio/post.hpp>

#include "roomcast/hub/admin/admin_answer.h"
#include "roomcast/hub/server/metrics_text.h"

namespace roomcast::hub {

namespace {

// What pages of other sites load to show a room (web/embed).
constexpr std::string_view kEmbedScript = "/roomcast-view.js";

constexpr char kNoPage[] =
    "This is a roomcast hub without the web viewer. Start it with --web DIR, where DIR holds the "
    "built page (build/web).\n";

}  // namespace

HubPages::HubPages(std::optional<net::StaticSite> site, RoomRegistry& registry,
                   StoreWorker& store_worker, boost::asio::io_context& rooms_io,
                   bool metrics_for_anyone, std::string version, RoomRecordings* recordings,
                   StudyDesk* study, RoomModels* models, const LogSink& log)
    : site_(std::move(site)),
      registry_(registry),
      rooms_io_(rooms_io),
      metrics_for_anyone_(metrics_for_anyone),
      version_(version),
      accept_io_(registry, store_worker, log),
      admin_(registry, store_worker, std::move(version), recordings, study, models, log) {}

std::vector<std::string> HubPages::request_paths() {
  return {"/api/", "/healthz", "/metrics"};
}

std::optional<net::HttpResponse> HubPages::find(std::string_view path,
                                                std::string_view query) const {
  if (site_) {
    auto page = site_->find(path);
    if (!page) return page;
    std::vector<std::string> sites;
    if (page->content_type.starts_with("text/html"))
      sites = registry_.embedding_sites(net::query_value(query, "room"));
    page->headers.emplace_back("Content-Security-Policy", peer_origins_.policy(sites));
    // Sites that are isolated themselves show only what says that anybody may load it.
    if (!sites.empty() || path == kEmbedScript)
      page->headers.emplace_back("Cross-Origin-Resource-Policy", "cross-origin");
    if (path == kEmbedScript) page->headers.emplace_back("Access-Control-Allow-Origin", "*");
    // A worker's policy is sent with its script, so the browser must revalidate the script.
    if (page->content_type.starts_with("text/javascript")) page->cache_control = "no-cache";
    return page;
  }
  if (path == "/") return net::text_response(200, kNoPage);
  return std::nullopt;
}

void HubPages::answer(net::HttpRequest request, net::Respond respond) {
  boost::asio::post(rooms_io_,
                    [this, request = std::move(request), respond = std::move(respond)]() mutable {
                      answer_here(request, std::move(respond));
                    });
}

void HubPages::answer_here(const net::HttpRequest& request, net::Respond respond) {
  if (request.path.starts_with("/api/")) return admin_.answer(request, std::move(respond));
  if (request.method != "GET") {
    return respond(net::text_response(405, "Only GET and HEAD are answered here.\n"));
  }
  if (request.path == "/healthz") return respond(health());
  if (request.path != "/metrics") {
    return respond(net::text_response(404, "There is nothing at this address.\n"));
  }
  if (metrics_for_anyone_) return respond(metrics());
  accept_io_.admit(request, true, std::move(respond), [this](const Caller& caller) {
    caller.respond(caller.is_hub_admin()
                       ? metrics()
                       : error_answer(Refusal{wire::pb::ERROR_WRONG_ROLE,
                                              "metrics need a token of the hub's admin"}));
  });
}

/// Open to everybody, so it counts listed rooms only.
net::HttpResponse HubPages::health() const {
  std::ptrdiff_t sensors = 0, viewers = 0;
  for (const RoomStats& stats : registry_.stats()) {
    if (!registry_.find(stats.room)->listed) continue;
    sensors += std::ranges::count_if(stats.sensors, &SensorStats::online);
    viewers += static_cast<std::ptrdiff_t>(stats.viewers.size());
  }
  return net::text_response(200, "ok, " + std::to_string(sensors) + " sensors, " +
                                     std::to_string(viewers) + " viewers\n");
}

net::HttpResponse HubPages::metrics() const {
  const HubStats hub{.version = version_,
                     .process = process_stats(),
                     .connections = server_ == nullptr ? 0 : server_->connection_count(),
                     .refused_joins = registry_.refused_joins(),
                     .banned_peers = registry_.banned_count(),
                     .backplane = registry_.backplane_stats()};
  return net::text_response(200, metrics_text(hub, registry_.stats()));
}

}  // namespace roomcast::hub
