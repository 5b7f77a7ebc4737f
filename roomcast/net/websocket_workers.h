// SPDX-License-Identifier: Apache-2.0
// WebSocketWorkers: the threads on which a server's WebSockets live, and among which they are dealt
// out when their request has been answered; each stays on one for life.
// Threading: any thread. Callbacks come from the worker that got the WebSocket.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <boost/asio/io_context.hpp>

#include "roomcast/net/http_server.h"
#include "roomcast/net/open_connections.h"
#include "roomcast/net/peer_counts.h"
#include "roomcast/net/stream.h"

namespace roomcast::net {

class WebSocketWorkers {
 public:
  WebSocketWorkers(std::span<boost::asio::io_context* const> threads,
                   std::shared_ptr<const HttpServerOptions> options);

  /// A connection that has become a WebSocket, and what came behind its request. Nobody may be
  /// waiting for the stream.
  void take(Stream stream, std::vector<std::uint8_t> received,
            std::shared_ptr<PeerCounts::Place> place);

  [[nodiscard]] std::size_t connection_count() const;
  /// With 1001, and those that still come as well.
  void end_all();

 private:
  struct Worker {
    boost::asio::io_context* io;
    std::shared_ptr<OpenConnections> connections;
  };
  struct Upgraded;

  [[nodiscard]] std::size_t least_busy() const;
  static void serve(Upgraded upgraded, std::size_t thread, const HttpServerOptions& options);

  const std::shared_ptr<const HttpServerOptions> options_;
  std::vector<Worker> workers_;
};

}  // namespace roomcast::net
