// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/server_state.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include <boost/asio/buffer.hpp>
#include <boost/asio/dispatch.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/ip/address.hpp>

#include "roomcast/net/http_session.h"
#include "roomcast/net/peer_name.h"

namespace roomcast::net {

namespace asio = boost::asio;

namespace {

/// After accepting failed (most likely: no file descriptors left), so that it does not fail in a
/// busy loop.
constexpr std::chrono::milliseconds kAcceptAgainAfter{100};

constexpr std::string_view kTurnedAway =
    "HTTP/1.1 503 Service Unavailable\r\n"
    "Content-Type: text/plain; charset=utf-8\r\n"
    "Content-Length: 42\r\n"
    "Connection: close\r\n"
    "Retry-After: 5\r\n"
    "\r\n"
    "The hub is full; please try again later.\r\n";

void warn(const LogSink& log, const std::string& why) {
  if (log) log(LogLevel::kWarning, "A connection could not be accepted: " + why + ".");
}

/// On the thread that the socket lives on.
void serve(const std::shared_ptr<const HttpServerOptions>& options, const LogSink& log,
           const std::shared_ptr<const TlsServerContext>& tls, asio::ip::tcp::socket socket,
           HttpSession::Origins origins) {
  std::optional<TlsSession> session;
  if (tls != nullptr) {
    auto accepted = TlsSession::accept(socket.native_handle(), *tls);
    if (!accepted) return warn(log, accepted.error().message);
    session = *std::move(accepted);
  }
  Stream stream(std::move(socket), std::move(session));
  std::make_shared<HttpSession>(std::move(stream), options, std::move(origins))->start();
}

}  // namespace

ServerState::ServerState(std::span<asio::io_context* const> threads, HttpServerOptions options,
                         LogSink log)
    : acceptor_(*threads.front()),
      retry_(*threads.front()),
      options_(std::make_shared<const HttpServerOptions>(std::move(options))),
      tls_(options_->tls),
      log_(std::move(log)) {
  for (asio::io_context* io : threads) {
    workers_.push_back({io, std::make_shared<OpenConnections>()});
  }
}

Status ServerState::listen() {
  ErrorCode error;
  const auto address = asio::ip::make_address(options_->address, error);
  if (error) {
    return Error{
        roomcast::ErrorCode::kInvalidArgument,
        "'" + options_->address + "' is not a numeric address to listen on; 0.0.0.0 means all."};
  }
  const Tcp::endpoint endpoint(address, options_->port);
  acceptor_.open(endpoint.protocol(), error);
  if (!error) acceptor_.set_option(Tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor_.bind(endpoint, error);
  if (!error) acceptor_.listen(asio::socket_base::max_listen_connections, error);
  if (error) return listen_error(error);
  port_ = acceptor_.local_endpoint(error).port();
  return {};
}

Error ServerState::listen_error(ErrorCode error) const {
  const std::string where = options_->address + ":" + std::to_string(options_->port);
  if (error == asio::error::address_in_use) {
    return {roomcast::ErrorCode::kUnavailable,
            "Port " + std::to_string(options_->port) + " is in use at " + options_->address +
                "; end the program that listens there or choose another port."};
  }
  if (error == asio::error::access_denied) {
    return {roomcast::ErrorCode::kUnavailable,
            "Listening on " + where + " is not allowed; choose a port above 1023."};
  }
  return {roomcast::ErrorCode::kUnavailable,
          "Cannot listen on " + where + ": " + error.message() + "."};
}

void ServerState::accept() {
  const std::size_t worker = least_busy();
  acceptor_.async_accept(*workers_[worker].io,
                         [self = shared_from_this(), worker](ErrorCode error, Tcp::socket socket) {
                           self->on_accept(error, worker, std::move(socket));
                         });
}

std::size_t ServerState::least_busy() const {
  const auto least = std::ranges::min_element(
      workers_, {}, [](const Worker& worker) { return worker.connections->count(); });
  return static_cast<std::size_t>(least - workers_.begin());
}

std::size_t ServerState::connection_count() const {
  std::size_t count = 0;
  for (const Worker& worker : workers_) count += worker.connections->count();
  return count;
}

void ServerState::on_accept(ErrorCode error, std::size_t worker, Tcp::socket socket) {
  if (!acceptor_.is_open()) return;
  if (error) return accept_later(error);
  take_in(worker, std::move(socket));
  accept();
}

void ServerState::take_in(std::size_t worker, Tcp::socket socket) {
  HttpSession::Origins origins{.thread = worker, .peer = peer_name(socket)};
  if (options_->may_connect && !options_->may_connect(origins.peer)) return;
  origins.place = unsettled_.enter(origins.peer, places_for(origins.peer));
  if (origins.place == nullptr) return;
  if (connection_count() >= options_->max_connections) return turn_away(std::move(socket));
  origins.lease = workers_[worker].connections->open();
  asio::dispatch(*workers_[worker].io,
                 [options = options_, log = log_, tls = tls_, socket = std::move(socket),
                  origins = std::move(origins)]() mutable {
                   serve(options, log, tls, std::move(socket), std::move(origins));
                 });
}

std::size_t ServerState::places_for(const std::string& peer) const {
  const auto& uncounted = options_->uncounted_peers;
  const bool counted = std::ranges::find(uncounted, peer) == uncounted.end();
  return counted ? options_->max_unsettled_per_peer : std::numeric_limits<std::size_t>::max();
}

void ServerState::accept_later(ErrorCode error) {
  warn(log_, error.message());
  retry_.expires_after(kAcceptAgainAfter);
  retry_.async_wait([self = shared_from_this()](ErrorCode cancelled) {
    if (!cancelled && self->acceptor_.is_open()) self->accept();
  });
}

/// As far as that goes without spending anything on it.
void ServerState::turn_away(Tcp::socket socket) const {
  if (tls_ != nullptr) return;  // a reason inside TLS would cost a handshake
  ErrorCode ignored;
  socket.non_blocking(true, ignored);
  socket.write_some(asio::buffer(kTurnedAway), ignored);
  socket.shutdown(Tcp::socket::shutdown_send, ignored);
}

void ServerState::stop() {
  ErrorCode ignored;
  acceptor_.close(ignored);
  retry_.cancel();
  for (const Worker& worker : workers_) {
    asio::dispatch(*worker.io, [connections = worker.connections] { connections->end_all(); });
  }
}

}  // namespace roomcast::net
