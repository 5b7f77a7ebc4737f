// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/hub_server.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <utility>
#include <vector>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>

#include "roomcast/core/clock.h"
#include "roomcast/hub/control_message.h"
#include "roomcast/hub/room.h"
#include "roomcast/hub/sensor_store.h"
#include "roomcast/hub/shard.h"
#include "roomcast/net/http_server.h"
#include "roomcast/net/static_site.h"
#include "roomcast/wire/limits.h"
#include "roomcast/wire/name_check.h"

namespace roomcast::hub {
namespace {

namespace asio = boost::asio;
constexpr std::chrono::seconds kGoodbyeWithin{3};  // a connection itself takes at most 2 s to close
constexpr std::chrono::milliseconds kGoodbyeLook{10};
constexpr std::chrono::milliseconds kStatsInterval{250};
constexpr char kNoPage[] =
    "This is a roomcast hub without the web viewer. Start it with --web DIR, where DIR holds the "
    "built page (build/web).\n";

std::string role_name(const wire::pb::Join& join) {
  if (join.has_sensor()) return "sensor";
  return join.has_aligner() ? "aligner" : "viewer";
}

}  // namespace

class HubServer::Loop final : public SessionEvents {
 public:
  Loop(HubOptions options, std::optional<net::StaticSite> site)
      : options_(std::move(options)),
        site_(std::move(site)),
        room_(options_.room, ROOMCAST_VERSION, options_.aligner_key) {
    const std::size_t count = std::max<std::size_t>(options_.threads, 1);
    for (std::size_t i = 0; i < count; ++i) loops_.push_back(std::make_unique<asio::io_context>(1));
    for (std::size_t i = 0; i < count; ++i) {
      shards_.push_back(std::make_unique<Shard>(Shard::Place{i, count, *loops_[i], io()}, *this,
                                                unjoined_, options_.join_within));
    }
    timer_.emplace(io());
  }

  ~Loop() override;

  void recall_sensors();
  Status listen();
  void run(std::stop_token stop);
  [[nodiscard]] std::uint16_t port() const { return http_->port(); }

  void on_join(ConnectionId from, const wire::pb::Join& join) override;
  void on_control(ConnectionId from, const wire::pb::Control& message) override;
  void on_frame(ConnectionId from, const wire::FrameHeader& header,
                net::MessageBuffer message) override;
  void on_key_needs(const std::vector<SensorId>& sensors) override;
  void on_left(ConnectionId from, const net::CloseReason& reason) override;

 private:
  Shard& shard_of(ConnectionId connection) {
    return *shards_[Shard::of(connection, shards_.size())];
  }
  void say_goodbye();
  std::optional<net::HttpResponse> answer(std::string_view path) const;
  std::string metrics() const;
  asio::io_context& io() { return *loops_.front(); }
  [[nodiscard]] RoomTime now() const { return RoomTime(clock_.now().time_since_epoch()); }

  void carry_out(RoomActions actions);
  void carry_out(const SendControl& action);
  void carry_out(const SendSet& action);
  void carry_out(const RestartSensor& action);
  void carry_out(const AcceptConnection& action);
  void carry_out(const Disconnect& action);
  void carry_out(const KeepSensors& action);
  void tell_other_threads();
  void schedule_tick();
  void log(LogLevel level, const std::string& line) const {
    if (options_.log) options_.log(level, line);
  }

  HubOptions options_;
  std::optional<net::StaticSite> site_;
  SteadyClock clock_;
  Room room_;
  std::unique_ptr<SensorStore> store_;  // null: nothing is kept
  // For other threads: what they are asked of the room.
  std::atomic<std::size_t> sensor_count_ = 0, viewer_count_ = 0;
  std::atomic<std::shared_ptr<const RoomStats>> stats_ = std::make_shared<const RoomStats>();
  RoomTime stats_at_{};
  UnjoinedCount unjoined_ = 0;
  // One per thread, the first is the room's.
  std::vector<std::unique_ptr<asio::io_context>> loops_;
  std::vector<std::unique_ptr<Shard>> shards_;
  std::optional<asio::steady_timer> timer_;
  std::optional<RoomTime> armed_for_;  // what timer_ waits for
  std::unique_ptr<net::HttpServer> http_;
};

// The first loop goes before the others: a socket that it would have accepted lives on one of them.
HubServer::Loop::~Loop() {
  http_.reset();
  timer_.reset();
  for (auto& loop : loops_) loop.reset();
}

/// A room that remembers nobody is better than none.
void HubServer::Loop::recall_sensors() {
  if (!options_.state_file) return;
  auto store = SensorStore::open(*options_.state_file);
  if (!store) return log(LogLevel::kWarning, store.error().message);
  auto sensors = (*store)->load(room_.name());
  if (!sensors) return log(LogLevel::kWarning, sensors.error().message);
  room_.remember(*std::move(sensors));
  store_ = *std::move(store);
}

Status HubServer::Loop::listen() {
  net::HttpServerOptions http;
  http.address = options_.address;
  http.port = options_.port;
  http.tls = options_.tls;
  http.on_get = [this](std::string_view path) { return answer(path); };
  http.on_websocket = [this](const auto& connection, std::size_t thread) {
    return shards_[thread]->welcome(connection);
  };
  http.max_message_bytes = wire::kMaxControlFromClientBytes;
  std::vector<asio::io_context*> threads;
  for (const auto& loop : loops_) threads.push_back(loop.get());
  auto server = net::HttpServer::listen(threads, std::move(http), options_.log);
  if (!server) return server.error();
  http_ = std::move(*server);
  return {};
}

void HubServer::Loop::run(std::stop_token stop) {
  const std::stop_callback wake_up(stop, [this] { asio::post(io(), [] {}); });
  std::vector<asio::executor_work_guard<asio::io_context::executor_type>> keep_alive;
  for (const auto& loop : loops_) keep_alive.push_back(asio::make_work_guard(*loop));
  std::vector<std::jthread> others;
  for (std::size_t i = 1; i < loops_.size(); ++i) {
    others.emplace_back([loop = loops_[i].get()] { loop->run(); });
  }
  while (!stop.stop_requested()) io().run_one();
  say_goodbye();
  for (std::size_t i = 1; i < loops_.size(); ++i) loops_[i]->stop();
}

void HubServer::Loop::say_goodbye() {
  http_->stop();
  const auto give_up = std::chrono::steady_clock::now() + kGoodbyeWithin;
  while (http_->connection_count() > 0 && std::chrono::steady_clock::now() < give_up) {
    io().run_one_for(kGoodbyeLook);
  }
}

std::optional<net::HttpResponse> HubServer::Loop::answer(std::string_view path) const {
  if (path == "/healthz") {
    return net::text_response(200, "ok, " + std::to_string(sensor_count_) + " sensors, " +
                                       std::to_string(viewer_count_) + " viewers\n");
  }
  if (path == "/metrics") return net::text_response(200, metrics());
  if (site_) return site_->find(path);
  if (path == "/") return net::text_response(200, kNoPage);
  return std::nullopt;
}

std::string HubServer::Loop::metrics() const {
  std::uint64_t dropped = 0;
  for (const auto& shard : shards_) dropped += shard->dropped_sets();
  return metrics_text(*stats_.load(), dropped);
}

void HubServer::Loop::on_join(ConnectionId from, const wire::pb::Join& join) {
  log(LogLevel::kInfo, role_name(join) + " \"" + join.name() + "\" joins");
  carry_out(room_.join(from, join, now()));
}

void HubServer::Loop::on_control(ConnectionId from, const wire::pb::Control& message) {
  carry_out(room_.control(from, message, now()));
}

void HubServer::Loop::on_frame(ConnectionId from, const wire::FrameHeader& header,
                               net::MessageBuffer message) {
  carry_out(room_.frame(from, header, std::move(message), now()));
}

void HubServer::Loop::on_key_needs(const std::vector<SensorId>& sensors) {
  for (const SensorId sensor : sensors) carry_out(room_.key_needed(sensor, now()));
}

void HubServer::Loop::on_left(ConnectionId from, const net::CloseReason& reason) {
  log(LogLevel::kInfo, "connection " + std::to_string(from.value) + " ended: " + reason.sentence);
  carry_out(room_.leave(from, now()));
}

void HubServer::Loop::carry_out(RoomActions actions) {
  for (const RoomAction& action : actions) {
    std::visit([this](const auto& a) { carry_out(a); }, action);
  }
  tell_other_threads();
  schedule_tick();
}

void HubServer::Loop::carry_out(const KeepSensors& action) {
  if (!store_) return;
  if (auto status = store_->save(room_.name(), action.sensors); !status) {
    log(LogLevel::kWarning, status.error().message);
  }
}

void HubServer::Loop::tell_other_threads() {
  const std::size_t sensors = room_.online_sensor_count(), viewers = room_.viewer_count();
  const bool sensors_changed = sensor_count_.exchange(sensors) != sensors;
  const bool viewers_changed = viewer_count_.exchange(viewers) != viewers;
  if (!sensors_changed && !viewers_changed && now() - stats_at_ < kStatsInterval) return;
  stats_at_ = now();
  stats_ = std::make_shared<const RoomStats>(room_.stats());
}

void HubServer::Loop::carry_out(const SendControl& action) {
  const auto message = sealed_control(action.message);
  std::vector<std::vector<ConnectionId>> to(shards_.size());
  for (const ConnectionId connection : action.to) {
    to[Shard::of(connection, shards_.size())].push_back(connection);
  }
  for (std::size_t i = 0; i < shards_.size(); ++i) {
    if (!to[i].empty()) shards_[i]->send_control(std::move(to[i]), message);
  }
}

void HubServer::Loop::carry_out(const SendSet& action) {
  for (const auto& shard : shards_) shard->send_set(action.set);
}

void HubServer::Loop::carry_out(const RestartSensor& action) {
  for (const auto& shard : shards_) shard->restart_sensor(action.sensor);
}

void HubServer::Loop::carry_out(const AcceptConnection& action) {
  shard_of(action.connection).accept(action.connection, action.role);
}

void HubServer::Loop::carry_out(const Disconnect& action) {
  shard_of(action.connection).disconnect(action.connection, action.code, action.sentence);
}

void HubServer::Loop::schedule_tick() {
  const auto next = room_.next_tick();
  if (!next || next == armed_for_) return;
  armed_for_ = next;
  timer_->expires_at(std::chrono::steady_clock::time_point(
      std::chrono::duration_cast<std::chrono::steady_clock::duration>(next->time_since_epoch())));
  timer_->async_wait([this](boost::system::error_code error) {
    if (error) return;
    armed_for_.reset();
    carry_out(room_.tick(now()));
  });
}

HubServer::HubServer(std::unique_ptr<Loop> loop) : loop_(std::move(loop)) {}
HubServer::~HubServer() = default;

Result<std::unique_ptr<HubServer>> HubServer::open(HubOptions options) {
  if (auto status = wire::check_name(options.room, "room"); !status) {
    return Error{ErrorCode::kInvalidArgument, status.error().message};
  }
  std::optional<net::StaticSite> site;
  if (options.web_directory) {
    auto loaded = net::StaticSite::load(*options.web_directory);
    if (!loaded) return loaded.error();
    site = std::move(*loaded);
  }
  auto loop = std::make_unique<Loop>(std::move(options), std::move(site));
  loop->recall_sensors();
  if (auto status = loop->listen(); !status) return status.error();
  return std::unique_ptr<HubServer>(new HubServer(std::move(loop)));
}

std::uint16_t HubServer::port() const {
  return loop_->port();
}

void HubServer::run(std::stop_token stop) {
  loop_->run(stop);
}

}  // namespace roomcast::hub
