// SPDX-License-Identifier: Apache-2.0
// ServerState: the listening socket of an HttpServer and its accept loop. Kept alive by its own
// pending operations, so that an HttpServer can be destroyed while its io_context still runs.
// Threading: lives on its io_context's thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>

#include "roomcast/core/log.h"
#include "roomcast/core/result.h"
#include "roomcast/net/http_server.h"
#include "roomcast/net/open_connections.h"

namespace roomcast::net {

class ServerState : public std::enable_shared_from_this<ServerState> {
 public:
  ServerState(boost::asio::io_context& io, HttpServerOptions options, LogSink log);

  Status listen();
  void accept();
  void stop();

  [[nodiscard]] std::uint16_t port() const { return port_; }
  [[nodiscard]] std::size_t connection_count() const { return connections_->count(); }

 private:
  using Tcp = boost::asio::ip::tcp;
  using ErrorCode = boost::system::error_code;

  [[nodiscard]] Error listen_error(ErrorCode error) const;
  void on_accept(ErrorCode error, Tcp::socket socket);
  void accept_later(ErrorCode error);
  void serve(Tcp::socket socket);
  void turn_away(Tcp::socket socket) const;
  void log_warning(const std::string& why) const;

  Tcp::acceptor acceptor_;
  boost::asio::steady_timer retry_;
  std::shared_ptr<const HttpServerOptions> options_;
  LogSink log_;
  std::shared_ptr<OpenConnections> connections_ = std::make_shared<OpenConnections>();
  std::uint16_t port_ = 0;
};

}  // namespace roomcast::net
