// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/http_server.h"

#include <array>
#include <utility>

#include "roomcast/net/server_state.h"

namespace roomcast::net {

Result<std::unique_ptr<HttpServer>> HttpServer::listen(boost::asio::io_context& io,
                                                       HttpServerOptions options, LogSink log) {
  return listen(io, std::array{&io}, std::move(options), std::move(log));
}

Result<std::unique_ptr<HttpServer>> HttpServer::listen(
    boost::asio::io_context& door, std::span<boost::asio::io_context* const> workers,
    HttpServerOptions options, LogSink log) {
  auto state = std::make_shared<ServerState>(door, workers, std::move(options), std::move(log));
  if (auto status = state->listen(); !status) return std::move(status).error();
  state->accept();
  return std::unique_ptr<HttpServer>(new HttpServer(std::move(state)));
}

HttpServer::HttpServer(std::shared_ptr<ServerState> state) : state_(std::move(state)) {}

HttpServer::~HttpServer() {
  stop();
}

std::uint16_t HttpServer::port() const {
  return state_->port();
}

std::size_t HttpServer::connection_count() const {
  return state_->connection_count();
}

void HttpServer::set_tls(std::shared_ptr<const TlsServerContext> tls) {
  state_->set_tls(std::move(tls));
}

void HttpServer::stop() {
  state_->stop();
}

}  // namespace roomcast::net
