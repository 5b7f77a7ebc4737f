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
#include <malloc.h>

#include "roomcast/net/http_session.h"
#include "roomcast/net/peer_name.h"

namespace roomcast::net {

namespace asio = boost::asio;

namespace {

/// Delay after a failed accept (most likely: no file descriptors left), to avoid a busy loop.
constexpr std::chrono::milliseconds kAcceptAgainAfter{100};

constexpr std::chrono::seconds kLookAtMemoryEvery{2};

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

ServerState::ServerState(asio::io_context& door, std::span<asio::io_context* const> workers,
                         HttpServerOptions options, LogSink log)
    : door_(door),
      acceptor_(door),
      retry_(door),
      memory_watch_(door),
      options_(std::make_shared<const HttpServerOptions>(std::move(options))),
      tls_(options_->tls),
      log_(std::move(log)),
      http_connections_(std::make_shared<OpenConnections>()),
      workers_(std::make_shared<WebSocketWorkers>(workers, options_)) {}

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
                "; end the program that uses it or choose another port."};
  }
  if (error == asio::error::access_denied) {
    return {roomcast::ErrorCode::kUnavailable,
            "Listening on " + where + " is not allowed; choose a port above 1023."};
  }
  return {roomcast::ErrorCode::kUnavailable,
          "Cannot listen on " + where + ": " + error.message() + "."};
}

void ServerState::accept() {
  acceptor_.async_accept([self = shared_from_this()](ErrorCode error, Tcp::socket socket) {
    self->on_accept(error, std::move(socket));
  });
}

std::size_t ServerState::connection_count() const {
  return http_connections_->count() + workers_->connection_count();
}

void ServerState::on_accept(ErrorCode error, Tcp::socket socket) {
  if (!acceptor_.is_open()) return;
  if (error) return accept_later(error);
  take_in(std::move(socket));
  accept();
}

void ServerState::take_in(Tcp::socket socket) {
  HttpSession::Origins origins{.peer = peer_name(socket), .workers = workers_};
  if (options_->may_connect && !options_->may_connect(origins.peer)) return;
  origins.place = unsettled_.enter(origins.peer, places_for(origins.peer));
  if (origins.place == nullptr) return;
  if (connection_count() >= options_->max_connections) return turn_away(std::move(socket));
  origins.lease = http_connections_->open();
  release_memory_after_floods();
  serve(options_, log_, tls_, std::move(socket), std::move(origins));
}

void ServerState::release_memory_after_floods() {
  const bool is_watched = peak_.is_high();
  peak_.note(connection_count());
  if (is_watched || !peak_.is_high()) return;
  memory_watch_.repeat(kLookAtMemoryEvery, [weak = weak_from_this()] {
    const auto self = weak.lock();
    if (!self) return;
    if (self->peak_.has_fallen(self->connection_count())) (void)::malloc_trim(0);
    if (!self->peak_.is_high()) self->memory_watch_.cancel();
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

/// Sends the reason only if that costs nothing.
void ServerState::turn_away(Tcp::socket socket) const {
  if (tls_ != nullptr) return;  // inside TLS it would cost a handshake
  ErrorCode ignored;
  socket.non_blocking(true, ignored);
  socket.write_some(asio::buffer(kTurnedAway), ignored);
  socket.shutdown(Tcp::socket::shutdown_send, ignored);
}

void ServerState::stop() {
  ErrorCode ignored;
  acceptor_.close(ignored);
  retry_.cancel();
  memory_watch_.stop();
  asio::dispatch(door_, [strangers = http_connections_] { strangers->end_all(); });
  workers_->end_all();
}

}  // namespace roomcast::net
