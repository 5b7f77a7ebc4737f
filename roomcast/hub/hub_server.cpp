// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/hub_server.h"

#include <unordered_map>
#include <utility>

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>

#include "roomcast/core/clock.h"
#include "roomcast/hub/control_message.h"
#include "roomcast/hub/room.h"
#include "roomcast/hub/session.h"
#include "roomcast/net/http_server.h"
#include "roomcast/net/static_site.h"
#include "roomcast/wire/limits.h"
#include "roomcast/wire/name_check.h"

namespace roomcast::hub {
namespace {

namespace asio = boost::asio;
constexpr std::chrono::seconds kGoodbyeWithin{3};  // a connection itself takes at most 2 s to close
constexpr char kNoPage[] =
    "This is a roomcast hub without the web viewer. Start it with --web DIR, where DIR holds the "
    "built page (build/web).\n";

}  // namespace

class HubServer::Loop final : public SessionEvents {
 public:
  Loop(HubOptions options, std::optional<net::StaticSite> site)
      : options_(std::move(options)),
        site_(std::move(site)),
        room_(options_.room, ROOMCAST_VERSION),
        timer_(io_) {}

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
  std::shared_ptr<net::ConnectionHandler> welcome(
      std::shared_ptr<net::WebSocketConnection> connection);
  void expect_join(ConnectionId id);
  std::optional<net::HttpResponse> answer(std::string_view path) const;
  [[nodiscard]] RoomTime now() const { return RoomTime(clock_.now().time_since_epoch()); }

  void carry_out(RoomActions actions);
  void carry_out(const SendControl& action);
  void carry_out(const SendSet& action);
  void carry_out(const RestartSensor& action);
  void carry_out(const AcceptConnection& action);
  void carry_out(const Disconnect& action);
  void schedule_tick();
  [[nodiscard]] std::size_t unjoined_count() const;
  void log(LogLevel level, const std::string& line) const {
    if (options_.log) options_.log(level, line);
  }

  HubOptions options_;
  std::optional<net::StaticSite> site_;
  SteadyClock clock_;
  Room room_;
  asio::io_context io_{1};
  asio::steady_timer timer_;
  std::optional<RoomTime> armed_for_;  // what timer_ waits for
  std::unique_ptr<net::HttpServer> http_;
  std::unordered_map<ConnectionId, std::shared_ptr<Session>> sessions_;
  std::uint64_t next_connection_ = 1;
};

Status HubServer::Loop::listen() {
  net::HttpServerOptions http;
  http.address = options_.address;
  http.port = options_.port;
  http.tls = options_.tls;
  http.on_get = [this](std::string_view path) { return answer(path); };
  http.on_websocket = [this](auto connection) { return welcome(std::move(connection)); };
  http.max_message_bytes = wire::kMaxControlFromClientBytes;
  auto server = net::HttpServer::listen(io_, std::move(http), options_.log);
  if (!server) return server.error();
  http_ = std::move(*server);
  return {};
}

void HubServer::Loop::run(std::stop_token stop) {
  const std::stop_callback wake_up(stop, [this] { asio::post(io_, [] {}); });
  const auto keep_alive = asio::make_work_guard(io_);
  while (!stop.stop_requested()) io_.run_one();
  http_->stop();
  const auto give_up = std::chrono::steady_clock::now() + kGoodbyeWithin;
  while (http_->connection_count() > 0 && io_.run_one_until(give_up) > 0) {
  }
}

std::shared_ptr<net::ConnectionHandler> HubServer::Loop::welcome(
    std::shared_ptr<net::WebSocketConnection> connection) {
  if (unjoined_count() >= wire::kMaxUnjoinedConnections) return nullptr;
  const ConnectionId id{next_connection_++};
  auto session = std::make_shared<Session>(id, connection, *this);
  sessions_[id] = session;
  expect_join(id);
  return session;
}

void HubServer::Loop::expect_join(ConnectionId id) {
  auto deadline = std::make_shared<asio::steady_timer>(io_, options_.join_within);
  deadline->async_wait([this, id, deadline](boost::system::error_code error) {
    const auto found = sessions_.find(id);
    if (error || found == sessions_.end() || found->second->has_joined()) return;
    found->second->disconnect(wire::pb::ERROR_UNEXPECTED, "no Join came in time after connecting");
  });
}

std::size_t HubServer::Loop::unjoined_count() const {
  return sessions_.size() - room_.online_sensor_count() - room_.viewer_count();
}

std::optional<net::HttpResponse> HubServer::Loop::answer(std::string_view path) const {
  if (path == "/healthz") {
    return net::text_response(200, "ok, " + std::to_string(room_.online_sensor_count()) +
                                       " sensors, " + std::to_string(room_.viewer_count()) +
                                       " viewers\n");
  }
  if (site_) return site_->find(path);
  if (path == "/") return net::text_response(200, kNoPage);
  return std::nullopt;
}

void HubServer::Loop::on_join(ConnectionId from, const wire::pb::Join& join) {
  log(LogLevel::kInfo, (join.has_sensor() ? "sensor \"" : "viewer \"") + join.name() + "\" joins");
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
  sessions_.erase(from);
  carry_out(room_.leave(from, now()));
}

void HubServer::Loop::carry_out(RoomActions actions) {
  for (const RoomAction& action : actions) {
    std::visit([this](const auto& a) { carry_out(a); }, action);
  }
  schedule_tick();
}

void HubServer::Loop::carry_out(const SendControl& action) {
  const auto message = sealed_control(action.message);
  for (const ConnectionId to : action.to) {
    const auto found = sessions_.find(to);
    if (found == sessions_.end() || found->second->send_control(message)) continue;
    carry_out(Disconnect{to, wire::pb::ERROR_TOO_SLOW, "control messages pile up unread"});
  }
}

void HubServer::Loop::carry_out(const SendSet& action) {
  for (const ConnectionId to : action.to) {
    if (const auto found = sessions_.find(to); found != sessions_.end())
      found->second->send_set(action.set);
  }
}

void HubServer::Loop::carry_out(const RestartSensor& action) {
  for (const ConnectionId to : action.to) {
    if (const auto found = sessions_.find(to); found != sessions_.end())
      found->second->restart_sensor(action.sensor);
  }
}

void HubServer::Loop::carry_out(const AcceptConnection& action) {
  if (const auto found = sessions_.find(action.connection); found != sessions_.end()) {
    found->second->accept(action.is_sensor);
  }
}

void HubServer::Loop::carry_out(const Disconnect& action) {
  if (const auto found = sessions_.find(action.connection); found != sessions_.end()) {
    found->second->disconnect(action.code, action.sentence);
  }
}

void HubServer::Loop::schedule_tick() {
  const auto next = room_.next_tick();
  if (!next || next == armed_for_) return;
  armed_for_ = next;
  timer_.expires_at(std::chrono::steady_clock::time_point(
      std::chrono::duration_cast<std::chrono::steady_clock::duration>(next->time_since_epoch())));
  timer_.async_wait([this](boost::system::error_code error) {
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
