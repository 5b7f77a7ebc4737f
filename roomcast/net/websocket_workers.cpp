// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/websocket_workers.h"

#include <algorithm>
#include <utility>

#include <boost/asio/dispatch.hpp>

#include "roomcast/net/websocket_connection.h"

namespace roomcast::net {

namespace asio = boost::asio;

namespace {

/// Handler of a WebSocket that is closed as soon as it is open.
class TurnedAway final : public ConnectionHandler {
 public:
  void on_message(MessageBuffer) override {}
  FramedMessagePtr next_message() override { return nullptr; }
  void on_closed(const CloseReason&) override {}
};

}  // namespace

struct WebSocketWorkers::Upgraded {
  Stream stream;
  std::vector<std::uint8_t> received;
  std::shared_ptr<OpenConnections::Lease> lease;
  std::shared_ptr<PeerCounts::Place> place;
};

WebSocketWorkers::WebSocketWorkers(std::span<asio::io_context* const> threads,
                                   std::shared_ptr<const HttpServerOptions> options)
    : options_(std::move(options)) {
  for (asio::io_context* io : threads) {
    workers_.push_back({io, std::make_shared<OpenConnections>()});
  }
}

std::size_t WebSocketWorkers::least_busy() const {
  const auto least = std::ranges::min_element(
      workers_, {}, [](const Worker& worker) { return worker.connections->count(); });
  return static_cast<std::size_t>(least - workers_.begin());
}

std::size_t WebSocketWorkers::connection_count() const {
  std::size_t count = 0;
  for (const Worker& worker : workers_) count += worker.connections->count();
  return count;
}

void WebSocketWorkers::take(Stream stream, std::vector<std::uint8_t> received,
                            std::shared_ptr<PeerCounts::Place> place) {
  const std::size_t thread = least_busy();
  const Worker& worker = workers_[thread];
  if (!stream.move_to(*worker.io)) return;
  asio::dispatch(*worker.io,
                 [thread, options = options_,
                  upgraded = Upgraded{std::move(stream), std::move(received),
                                      worker.connections->open(), std::move(place)}]() mutable {
                   serve(std::move(upgraded), thread, *options);
                 });
}

/// Runs on the thread of the worker.
void WebSocketWorkers::serve(Upgraded upgraded, std::size_t thread,
                             const HttpServerOptions& options) {
  ConnectionOptions connection_options;
  connection_options.role = WebSocketRole::kServer;
  connection_options.max_message_bytes = options.max_message_bytes;
  connection_options.timings = options.websocket_timings;
  connection_options.lease = upgraded.lease;
  connection_options.place = std::move(upgraded.place);
  auto connection = std::make_shared<WebSocketConnection>(
      std::move(upgraded.stream), std::move(connection_options), upgraded.received);
  upgraded.lease->end_with([weak = std::weak_ptr(connection)] {
    if (const auto open = weak.lock()) open->close(close_code::kGoingAway, "The hub stops.");
  });
  upgraded.lease.reset();

  auto handler = options.on_websocket ? options.on_websocket(connection, thread) : nullptr;
  if (handler != nullptr) return connection->start(std::move(handler));
  connection->close(close_code::kTryAgainLater, "The hub accepts no more connections.");
  connection->start(std::make_shared<TurnedAway>());
}

void WebSocketWorkers::end_all() {
  for (const Worker& worker : workers_) {
    asio::dispatch(*worker.io, [connections = worker.connections] { connections->end_all(); });
  }
}

}  // namespace roomcast::net
