// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/server/hub_server.h"

#include <algorithm>
#include <map>
#include <set>
#include <thread>
#include <utility>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <sys/resource.h>
#include <unistd.h>

#include "roomcast/hub/admin/token_request.h"
#include "roomcast/hub/runtime/room_registry.h"
#include "roomcast/hub/runtime/shard.h"
#include "roomcast/hub/server/hub_pages.h"
#include "roomcast/hub/store/store_worker.h"
#include "roomcast/net/http_server.h"

namespace roomcast::hub {
namespace {

namespace asio = boost::asio;
constexpr std::chrono::seconds kCloseTimeout{3};  // a connection itself takes at most 2 s to close
constexpr std::chrono::milliseconds kClosePollInterval{10};
constexpr UnixSeconds kLinkTokenTtl = 24 * 3600;
constexpr int kAcceptThreadNiceness = 10;  // clients in rooms go before new connections

/// The rooms of the options, replaced and extended by those that the store has.
std::map<std::string, RoomSettings> rooms_to_open(const HubOptions& options,
                                                  const std::vector<RoomSettings>& kept) {
  std::map<std::string, RoomSettings> rooms;
  for (const RoomSettings& room : options.rooms) rooms[room.name] = room;
  for (const RoomSettings& room : kept) rooms[room.name] = room;
  return rooms;
}

/// Of a link with a one-time code for this grant; empty without a grant.
Result<std::string> make_link_fragment(const std::optional<Grant>& grant, HubStore& store) {
  if (!grant) return std::string();
  const auto made = make_token_for({.grant = *grant, .ttl = kLinkTokenTtl, .once = true}, store);
  if (!made) return made.error();
  return made->at("fragment").get<std::string>();
}

std::set<std::string> names_of(const std::vector<RoomSettings>& rooms) {
  std::set<std::string> names;
  for (const RoomSettings& room : rooms) names.insert(room.name);
  return names;
}

}  // namespace

class HubServer::Loop {
 public:
  Loop(HubOptions options, std::unique_ptr<HubStore> store, std::string link_fragment,
       std::optional<net::StaticSite> site);
  ~Loop();

  /// Must be called before any room is opened.
  Status open_backplane();
  void open_rooms(const std::map<std::string, RoomSettings>& rooms,
                  std::map<std::string, KnownRoom> known);
  Status listen();
  void run(const std::stop_token& stop);
  [[nodiscard]] std::uint16_t port() const { return http_->port(); }
  [[nodiscard]] const std::string& own_token() const { return own_token_; }
  [[nodiscard]] const std::string& link_fragment() const { return link_fragment_; }
  void replace_tls(std::shared_ptr<const net::TlsServerContext> tls);

 private:
  [[nodiscard]] net::HttpServerOptions http_options();
  void close_connections();
  asio::io_context& io() { return *loops_.front(); }

  HubOptions options_;
  const std::string own_token_;
  const std::string link_fragment_;
  ConnectionIds connection_ids_;
  UnjoinedCount unjoined_ = 0;
  // One per thread; the first is the rooms'.
  std::vector<std::unique_ptr<asio::io_context>> loops_;
  std::unique_ptr<asio::io_context> accept_io_ = std::make_unique<asio::io_context>(1);
  std::vector<std::unique_ptr<Shard>> shards_;
  std::unique_ptr<StoreWorker> store_worker_;
  std::unique_ptr<RoomRegistry> registry_;
  std::unique_ptr<Backplane> backplane_;
  std::unique_ptr<HubPages> pages_;
  std::unique_ptr<net::HttpServer> http_;
};

HubServer::Loop::Loop(HubOptions options, std::unique_ptr<HubStore> store,
                      std::string link_fragment, std::optional<net::StaticSite> site)
    : options_(std::move(options)),
      own_token_(store->sign_own()),
      link_fragment_(std::move(link_fragment)) {
  const std::size_t count = std::max<std::size_t>(options_.threads, 1);
  for (std::size_t i = 0; i < count; ++i) loops_.push_back(std::make_unique<asio::io_context>(1));
  store_worker_ = std::make_unique<StoreWorker>(std::move(store), io());
  registry_ = std::make_unique<RoomRegistry>(
      RoomRegistryOptions{.hub_version = ROOMCAST_VERSION,
                          .restores_poses = options_.restores_poses,
                          .configured_rooms = names_of(options_.rooms),
                          .bans = options_.limits.bans,
                          .never_banned = options_.limits.proxies,
                          .on_in_use = options_.on_room_in_use,
                          .log = options_.log},
      io(), *store_worker_, shards_);
  for (std::size_t i = 0; i < count; ++i) {
    shards_.push_back(std::make_unique<Shard>(
        Shard::Loops{*loops_[i], io()}, *registry_, connection_ids_, unjoined_,
        ShardLimits{options_.join_within, options_.limits.max_unjoined, options_.limits.session}));
  }
  pages_ = std::make_unique<HubPages>(std::move(site), *registry_, *store_worker_, io(),
                                      options_.metrics_for_anyone, ROOMCAST_VERSION,
                                      options_.recordings.get(), options_.study.get(),
                                      options_.models.get(), options_.log);
}

// The store worker and questions about recordings and the study go first: their work ends, and
// their last answers go to a loop that still exists. The rooms' loop goes before the accept loop,
// because handlers pending there own HTTP sessions that use the accept loop.
HubServer::Loop::~Loop() {
  store_worker_.reset();
  if (options_.recordings) options_.recordings->kept().settle();
  if (options_.study) options_.study->settle();
  http_.reset();
  pages_.reset();
  backplane_.reset();
  registry_.reset();
  loops_.front().reset();
  accept_io_.reset();
  for (auto& loop : loops_) loop.reset();
}

Status HubServer::Loop::open_backplane() {
  if (!options_.open_backplane) return {};
  auto opened = options_.open_backplane(
      {.io = io(),
       .rooms = *registry_,
       .connection_ids = connection_ids_,
       .token = own_token_,
       .revoke = [this](std::vector<Claims> tokens) { registry_->add_revoked(std::move(tokens)); },
       .send_revoked = [this] { registry_->send_revoked(); },
       .set_peer_urls =
           [this](std::vector<std::string> urls) {
             asio::post(*accept_io_,
                        [this, urls = std::move(urls)] { pages_->peer_origins().add(urls); });
           }});
  if (!opened) return opened.error();
  backplane_ = *std::move(opened);
  registry_->connect(*backplane_);
  return {};
}

void HubServer::Loop::open_rooms(const std::map<std::string, RoomSettings>& rooms,
                                 std::map<std::string, KnownRoom> known) {
  for (const auto& [name, settings] : rooms) registry_->open(settings, std::move(known[name]));
}

net::HttpServerOptions HubServer::Loop::http_options() {
  net::HttpServerOptions http;
  http.address = options_.address;
  http.port = options_.port;
  http.tls = options_.tls;
  http.names = options_.names;
  http.allows_origin = [this](std::string_view origin) {
    return pages_->peer_origins().has(origin);
  };
  http.on_get = [this](std::string_view path, std::string_view query) {
    return pages_->find(path, query);
  };
  http.request_paths = HubPages::request_paths();
  http.on_request = [this](net::HttpRequest request, net::Respond respond) {
    pages_->answer(std::move(request), std::move(respond));
  };
  http.on_websocket = [this](const auto& connection, std::size_t thread) {
    return shards_[thread]->add_session(connection);
  };
  http.may_connect = [this](const std::string& peer) { return registry_->may_connect(peer); };
  http.max_connections = options_.limits.max_connections;
  http.max_unsettled_per_peer = options_.limits.max_unsettled_per_peer;
  http.uncounted_peers = options_.limits.proxies;
  http.max_message_bytes = wire::kMaxControlFromClientBytes;
  return http;
}

Status HubServer::Loop::listen() {
  std::vector<asio::io_context*> workers;
  for (const auto& loop : loops_) workers.push_back(loop.get());
  auto server = net::HttpServer::listen(*accept_io_, workers, http_options(), options_.log);
  if (!server) return server.error();
  http_ = std::move(*server);
  pages_->count_connections_of(*http_);
  return {};
}

void HubServer::Loop::replace_tls(std::shared_ptr<const net::TlsServerContext> tls) {
  asio::post(*accept_io_,
             [this, tls = std::move(tls)]() mutable { http_->set_tls(std::move(tls)); });
}

void HubServer::Loop::run(const std::stop_token& stop) {
  const std::stop_callback wake_up(stop, [this] { asio::post(io(), [] {}); });
  std::vector<asio::executor_work_guard<asio::io_context::executor_type>> keep_alive;
  for (const auto& loop : loops_) keep_alive.push_back(asio::make_work_guard(*loop));
  keep_alive.push_back(asio::make_work_guard(*accept_io_));
  std::vector<std::jthread> others;
  others.emplace_back([this] {
    (void)::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kAcceptThreadNiceness);
    accept_io_->run();
  });
  for (std::size_t i = 1; i < loops_.size(); ++i) {
    others.emplace_back([loop = loops_[i].get()] { loop->run(); });
  }
  registry_->start();
  while (!stop.stop_requested()) io().run_one();
  close_connections();
  for (std::size_t i = 1; i < loops_.size(); ++i) loops_[i]->stop();
  accept_io_->stop();
}

void HubServer::Loop::close_connections() {
  asio::post(*accept_io_, [this] { http_->stop(); });
  const auto give_up = std::chrono::steady_clock::now() + kCloseTimeout;
  while (http_->connection_count() > 0 && std::chrono::steady_clock::now() < give_up) {
    io().run_one_for(kClosePollInterval);
  }
}

HubServer::HubServer(std::unique_ptr<Loop> loop) : loop_(std::move(loop)) {}
HubServer::~HubServer() = default;

Result<std::unique_ptr<HubServer>> HubServer::open(HubOptions options) {
  for (const RoomSettings& room : options.rooms) {
    if (auto status = check(room); !status) return status.error();
  }
  std::optional<net::StaticSite> site;
  if (options.web_directory) {
    auto loaded = net::StaticSite::load(*options.web_directory);
    if (!loaded) return loaded.error();
    site = std::move(*loaded);
  }
  auto store = HubStore::open(options.data_folder);
  if (!store) return store.error();
  const auto kept = (*store)->rooms().load();
  if (!kept) return kept.error();
  const auto rooms = rooms_to_open(options, *kept);
  std::map<std::string, KnownRoom> known;
  for (const auto& [name, settings] : rooms) {
    auto sensors = (*store)->sensors().load(name);
    if (!sensors) return sensors.error();
    auto marks = (*store)->marks().load(name);
    if (!marks) return marks.error();
    known[name] = {*std::move(sensors), *std::move(marks)};
  }
  auto link = make_link_fragment(options.first_link, **store);
  if (!link) return link.error();
  auto loop = std::make_unique<Loop>(std::move(options), *std::move(store), *std::move(link),
                                     std::move(site));
  if (auto status = loop->open_backplane(); !status) return status.error();
  loop->open_rooms(rooms, std::move(known));
  if (auto status = loop->listen(); !status) return status.error();
  return std::unique_ptr<HubServer>(new HubServer(std::move(loop)));
}

std::uint16_t HubServer::port() const {
  return loop_->port();
}

const std::string& HubServer::own_token() const {
  return loop_->own_token();
}

const std::string& HubServer::link_fragment() const {
  return loop_->link_fragment();
}

void HubServer::replace_tls(std::shared_ptr<const net::TlsServerContext> tls) {
  loop_->replace_tls(std::move(tls));
}

void HubServer::run(std::stop_token stop) {
  loop_->run(stop);
}

}  // namespace roomcast::hub
