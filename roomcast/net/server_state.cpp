// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/server_state.h"

#include <chrono>
#include <string>
#include <string_view>
#include <utility>

#include <boost/asio/buffer.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/ip/address.hpp>

#include "roomcast/net/http_session.h"

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

}  // namespace

ServerState::ServerState(asio::io_context& io, HttpServerOptions options, LogSink log)
    : acceptor_(io),
      retry_(io),
      options_(std::make_shared<const HttpServerOptions>(std::move(options))),
      log_(std::move(log)) {}

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
  acceptor_.async_accept([self = shared_from_this()](ErrorCode error, Tcp::socket socket) {
    self->on_accept(error, std::move(socket));
  });
}

void ServerState::on_accept(ErrorCode error, Tcp::socket socket) {
  if (!acceptor_.is_open()) return;
  if (error) return accept_later(error);
  if (connections_->count() >= options_->max_connections) {
    turn_away(std::move(socket));
  } else {
    serve(std::move(socket));
  }
  accept();
}

void ServerState::accept_later(ErrorCode error) {
  log_warning(error.message());
  retry_.expires_after(kAcceptAgainAfter);
  retry_.async_wait([self = shared_from_this()](ErrorCode cancelled) {
    if (!cancelled && self->acceptor_.is_open()) self->accept();
  });
}

void ServerState::serve(Tcp::socket socket) {
  std::optional<TlsSession> tls;
  if (options_->tls != nullptr) {
    auto session = TlsSession::accept(socket.native_handle(), *options_->tls);
    if (!session) return log_warning(session.error().message);
    tls = *std::move(session);
  }
  Stream stream(std::move(socket), std::move(tls));
  std::make_shared<HttpSession>(std::move(stream), options_, connections_->open())->start();
}

void ServerState::log_warning(const std::string& why) const {
  if (log_) log_(LogLevel::kWarning, "A connection could not be accepted: " + why + ".");
}

/// As far as that goes without spending anything on it.
void ServerState::turn_away(Tcp::socket socket) const {
  if (options_->tls != nullptr) return;  // a reason inside TLS would cost a handshake
  ErrorCode ignored;
  socket.non_blocking(true, ignored);
  socket.write_some(asio::buffer(kTurnedAway), ignored);
  socket.shutdown(Tcp::socket::shutdown_send, ignored);
}

void ServerState::stop() {
  ErrorCode ignored;
  acceptor_.close(ignored);
  retry_.cancel();
  connections_->end_all();
}

}  // namespace roomcast::net
