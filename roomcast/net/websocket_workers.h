// SPDX-License-Identifier: Apache-2.0
// WebSocketWorkers: the threads that serve a server's WebSockets. After the upgrade each WebSocket
// is assigned to the thread with the fewest connections and stays there. Threading: any thread.
// Callbacks are called on the WebSocket's worker.
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

  /// Takes a connection upgraded to a WebSocket, and the bytes that followed its request. No
  /// operation may be pending on the stream.
  void take(Stream stream, std::vector<std::uint8_t> received,
            std::shared_ptr<PeerCounts::Place> place);

  [[nodiscard]] std::size_t connection_count() const;
  /// Closes all with 1001, and those that arrive later as well.
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
