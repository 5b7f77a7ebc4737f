// SPDX-License-Identifier: Apache-2.0
// ServerState: the listening socket of an HttpServer and its accept loop. Its pending operations
// keep it alive, so that an HttpServer can be destroyed while its io_contexts still run. Threading:
// runs on the door's thread; port() and connection_count() from any.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>

#include "roomcast/core/log.h"
#include "roomcast/core/result.h"
#include "roomcast/net/connection_peak.h"
#include "roomcast/net/http_server.h"
#include "roomcast/net/open_connections.h"
#include "roomcast/net/peer_counts.h"
#include "roomcast/net/timer.h"
#include "roomcast/net/websocket_workers.h"

namespace roomcast::net {

class ServerState : public std::enable_shared_from_this<ServerState> {
 public:
  ServerState(boost::asio::io_context& door, std::span<boost::asio::io_context* const> workers,
              HttpServerOptions options, LogSink log);

  Status listen();
  void accept();
  void stop();
  void set_tls(std::shared_ptr<const TlsServerContext> tls) { tls_ = std::move(tls); }

  [[nodiscard]] std::uint16_t port() const { return port_; }
  [[nodiscard]] std::size_t connection_count() const;

 private:
  using Tcp = boost::asio::ip::tcp;
  using ErrorCode = boost::system::error_code;

  [[nodiscard]] Error listen_error(ErrorCode error) const;
  void on_accept(ErrorCode error, Tcp::socket socket);
  void accept_later(ErrorCode error);
  void take_in(Tcp::socket socket);
  void turn_away(Tcp::socket socket) const;
  [[nodiscard]] std::size_t places_for(const std::string& peer) const;
  void release_memory_after_floods();

  boost::asio::io_context& door_;
  Tcp::acceptor acceptor_;
  boost::asio::steady_timer retry_;
  Timer memory_watch_;  // runs while there are many connections
  ConnectionPeak peak_;
  std::shared_ptr<const HttpServerOptions> options_;
  std::shared_ptr<const TlsServerContext> tls_;
  PeerCounts unsettled_;
  LogSink log_;
  const std::shared_ptr<OpenConnections> http_connections_;  // not, or not yet, WebSockets
  const std::shared_ptr<WebSocketWorkers> workers_;
  std::uint16_t port_ = 0;
};

}  // namespace roomcast::net
