// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/nats/nats_client.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <boost/asio/post.hpp>

#include "roomcast/hub/federation/nats/nats_login.h"
#include "roomcast/hub/federation/nats/nats_session.h"
#include "roomcast/net/timer.h"

namespace roomcast::hub::federation {
namespace {

namespace asio = boost::asio;

constexpr std::chrono::milliseconds kRetryAfter{500};
/// A server silent for kPingAfter is pinged every kPingEvery, and abandoned after kTimeout.
/// With another hub in the cluster its heartbeats are more frequent, so no ping is needed.
constexpr std::chrono::milliseconds kPingAfter{200}, kPingEvery{50}, kTimeout{400};
constexpr std::size_t kUsualMessageBytes = 1u << 20;

/// Rotates the servers so that the one after `last` comes first and `last` itself, which is gone or
/// hangs, comes last.
NatsOptions from_next(NatsOptions options, const std::string& last) {
  const auto found = std::ranges::find(options.servers, last, without_secret);
  if (found != options.servers.end()) {
    std::rotate(options.servers.begin(), found + 1, options.servers.end());
  }
  return options;
}

}  // namespace

// Runs sessions one after another.
class NatsClient::Link : public std::enable_shared_from_this<Link> {
 public:
  Link(NatsOptions options, asio::io_context& io, NatsHandlers handlers)
      : options_(std::move(options)),
        io_(io),
        handlers_(std::move(handlers)),
        retry_timer_(io),
        silence_timer_(io) {}

  Status connect_first() {
    asio::io_context alone;
    std::optional<Result<NatsConnection>> made;
    log_in_to_nats(alone, options_,
                   [&made](Result<NatsConnection> login) { made = std::move(login); });
    while (!made) alone.run_one();
    if (!*made) return made->error();
    NatsConnection connection = *std::move(*made);
    if (!connection.stream.move_to(io_)) {
      return connect_error(NatsFault::kNoAnswer, connection.server, options_);
    }
    begin(std::move(connection));
    return {};
  }
  void start() { schedule_check(); }
  void stop() {
    is_stopped_ = true;
    retry_timer_.stop();
    silence_timer_.stop();
    if (connecting_) connecting_->cancel();
    if (session_) session_->stop();
  }

  void reconnect_later() {
    retry_timer_.once(kRetryAfter, [this] { reconnect(); });
  }

  void subscribe(std::string subject) {
    if (session_) session_->subscribe(subject);
    subjects_.push_back(std::move(subject));
  }
  void unsubscribe(const std::string& subject) {
    std::erase(subjects_, subject);
    if (session_) session_->unsubscribe(subject);
  }
  void publish(std::string subject, std::vector<std::uint8_t> message, bool keep) {
    if (session_) return send(subject, message);
    if (!keep || kept_bytes_ + message.size() > kMaxWaitingBytes) {
      ++stats_.dropped;
      return;
    }
    kept_bytes_ += message.size();
    kept_.emplace_back(std::move(subject), std::move(message));
  }
  [[nodiscard]] NatsStats stats() const {
    NatsStats stats = stats_;
    stats.is_connected = session_ != nullptr;
    return stats;
  }
  [[nodiscard]] std::size_t max_message_bytes() const {
    return session_ ? session_->max_message_bytes() : kUsualMessageBytes;
  }
  void log(LogLevel level, const std::string& line) const {
    if (handlers_.log) handlers_.log(level, line);
  }

 private:
  void begin(NatsConnection connection) {
    last_logged_.clear();
    session_ = std::make_shared<NatsSession>(std::move(connection));
    server_ = session_->server();
    started_ = clock_.now();
    session_->start({.on_message = [this](auto subject, auto message) { take(subject, message); },
                     .on_lost = [this] { on_lost(); }});
    for (const std::string& subject : subjects_) session_->subscribe(subject);
    for (const auto& [subject, message] : kept_) send(subject, message);
    kept_.clear();
    kept_bytes_ = 0;
    log(LogLevel::kInfo, "connected to " + server_);
    asio::post(io_, [weak = weak_from_this()] {
      const auto self = weak.lock();
      if (self && !self->is_stopped_) self->handlers_.on_connected();
    });
  }

  void send(const std::string& subject, std::span<const std::uint8_t> message) {
    if (session_->publish(subject, message, kMaxWaitingBytes)) {
      count(message.size(), stats_.sent);
    } else {
      ++stats_.dropped;
    }
  }

  static void count(std::size_t bytes, hub::BackplaneTraffic& traffic) {
    ++traffic.messages;
    traffic.bytes += bytes;
  }

  void take(std::string_view subject, std::span<const std::uint8_t> message) {
    count(message.size(), stats_.received);
    handlers_.on_message(subject, message);
  }

  void on_lost() {
    log(LogLevel::kWarning, "NATS at " + server_ + " is gone");
    session_ = nullptr;
    const bool has_lasted = clock_.now() - started_ >= kRetryAfter;
    if (!has_lasted) return reconnect_later();  // no retries without a pause
    reconnect();
  }

  void reconnect() {
    connecting_ =
        log_in_to_nats(io_, from_next(options_, server_),
                       [this](Result<NatsConnection> made) { on_login(std::move(made)); });
  }

  void on_login(Result<NatsConnection> made) {
    if (made) return begin(*std::move(made));
    const std::string& why = made.error().message;
    if (std::exchange(last_logged_, why) != why) log(LogLevel::kWarning, why);
    reconnect_later();
  }

  void schedule_check() {
    const HostTime now = clock_.now();
    const HostTime silent_since = session_ ? session_->last_received() : now;
    const HostTime due = std::max<HostTime>(silent_since + kPingAfter, now + kPingEvery);
    silence_timer_.once(due - now, [this, due] {
      check_silence(due);
      schedule_check();
    });
  }

  /// A late check gives no verdict: this program may have been kept from reading the server's
  /// messages.
  void check_silence(HostTime due) {
    if (!session_) return;
    const HostTime now = clock_.now();
    const nanoseconds silent = now - session_->last_received();
    const bool is_on_time = now - due < kPingEvery;
    if (silent > kTimeout && is_on_time) return session_->abort();
    if (silent >= kPingAfter) session_->ping();
  }

  const NatsOptions options_;
  asio::io_context& io_;
  const NatsHandlers handlers_;
  SteadyClock clock_;
  std::shared_ptr<NatsSession> session_;  // null while there is none
  std::string server_;                    // server of the newest session...
  HostTime started_{};                    // ...and its start
  std::vector<std::string> subjects_;
  std::vector<std::pair<std::string, std::vector<std::uint8_t>>> kept_;
  std::size_t kept_bytes_ = 0;
  NatsStats stats_;  // except is_connected
  std::string last_logged_;
  bool is_stopped_ = false;
  net::Timer retry_timer_, silence_timer_;
  std::shared_ptr<NatsLoginAttempt> connecting_;
};

Result<std::unique_ptr<NatsClient>> NatsClient::open(NatsOptions options, asio::io_context& io,
                                                     NatsHandlers handlers) {
  if (auto status = check(options); !status) return status.error();
  auto link = std::make_shared<Link>(std::move(options), io, std::move(handlers));
  if (auto status = link->connect_first(); !status) {
    if (status.error().code != ErrorCode::kUnavailable) return status.error();
    link->log(LogLevel::kWarning, status.error().message + "; retrying");
    link->reconnect_later();
  }
  link->start();
  return std::unique_ptr<NatsClient>(new NatsClient(std::move(link)));
}

NatsClient::NatsClient(std::shared_ptr<Link> link) : link_(std::move(link)) {}
NatsClient::~NatsClient() {
  link_->stop();
}

void NatsClient::subscribe(std::string subject) {
  link_->subscribe(std::move(subject));
}

void NatsClient::unsubscribe(const std::string& subject) {
  link_->unsubscribe(subject);
}

void NatsClient::publish(std::string subject, std::vector<std::uint8_t> message) {
  link_->publish(std::move(subject), std::move(message), true);
}

void NatsClient::publish_now(std::string subject, std::vector<std::uint8_t> message) {
  link_->publish(std::move(subject), std::move(message), false);
}

std::size_t NatsClient::max_message_bytes() const {
  return link_->max_message_bytes();
}

NatsStats NatsClient::stats() const {
  return link_->stats();
}

}  // namespace roomcast::hub::federation
