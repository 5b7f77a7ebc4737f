// SPDX-License-Identifier: Apache-2.0
// ServerState: the listening socket of an HttpServer, its accept loop, and the threads among which
// it deals out what it accepts. Kept alive by its own pending operations, so that an HttpServer can
// be destroyed while its io_contexts still run. Threading: lives on the first io_context's thread;
// each connection on one of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>

#include "roomcast/core/log.h"
#include "roomcast/core/result.h"
#include "roomcast/net/http_server.h"
#include "roomcast/net/open_connections.h"
#include "roomcast/net/peer_counts.h"

namespace roomcast::net {

class ServerState : public std::enable_shared_from_this<ServerState> {
 public:
  ServerState(std::span<boost::asio::io_context* const> threads, HttpServerOptions options,
              LogSink log);

  Status listen();
  void accept();
  void stop();
  void set_tls(std::shared_ptr<const TlsServerContext> tls) { tls_ = std::move(tls); }

  [[nodiscard]] std::uint16_t port() const { return port_; }
  [[nodiscard]] std::size_t connection_count() const;

 private:
  using Tcp = boost::asio::ip::tcp;
  using ErrorCode = boost::system::error_code;

  struct Worker {
    boost::asio::io_context* io;
    std::shared_ptr<OpenConnections> connections;
  };

  [[nodiscard]] Error listen_error(ErrorCode error) const;
  [[nodiscard]] std::size_t least_busy() const;
  void on_accept(ErrorCode error, std::size_t worker, Tcp::socket socket);
  void accept_later(ErrorCode error);
  void take_in(std::size_t worker, Tcp::socket socket);
  void turn_away(Tcp::socket socket) const;
  [[nodiscard]] std::size_t places_for(const std::string& peer) const;

  Tcp::acceptor acceptor_;
  boost::asio::steady_timer retry_;
  std::shared_ptr<const HttpServerOptions> options_;
  std::shared_ptr<const TlsServerContext> tls_;
  PeerCounts unsettled_;
  LogSink log_;
  std::vector<Worker> workers_;
  std::uint16_t port_ = 0;
};

}  // namespace roomcast::net
