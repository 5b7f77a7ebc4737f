// SPDX-License-Identifier: Apache-2.0
// NatsClient: a hub's connection to a NATS cluster (docs.nats.io). If its node is gone or hangs, it
// connects to another one; messages sent meanwhile may be lost, as always with NATS.
//
// Threading: created, used and destroyed on the thread that runs `io`, where the handlers are
// called; only open() blocks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <boost/asio/io_context.hpp>

#include "roomcast/core/log.h"
#include "roomcast/core/result.h"
#include "roomcast/hub/federation/nats/nats_options.h"
#include "roomcast/hub/runtime/backplane.h"

namespace roomcast::hub::federation {

/// Totals since it was opened.
struct NatsStats {
  bool is_connected = false;
  hub::BackplaneTraffic sent = {}, received = {};
  std::uint64_t dropped = 0;  // messages, for lack of a connection or because of a slow one
};

struct NatsHandlers {
  /// Must not destroy the client.
  std::function<void(std::string_view subject, std::span<const std::uint8_t> message)> on_message;
  /// Connected, possibly to another node than before.
  std::function<void()> on_connected;
  LogSink log;
};

class NatsClient {
 public:
  /// Limit of the bytes waiting to be sent; messages beyond it are dropped.
  static constexpr std::size_t kMaxWaitingBytes = 8u << 20;

  /// Waits for the first connection, at most kConnectWithin for each server; if none answers, it
  /// keeps trying. Errors of check() and log_in_to_nats().
  static Result<std::unique_ptr<NatsClient>> open(NatsOptions options, boost::asio::io_context& io,
                                                  NatsHandlers handlers);
  ~NatsClient();

  void subscribe(std::string subject);
  void unsubscribe(const std::string& subject);
  /// Kept and sent later if there is no connection now.
  void publish(std::string subject, std::vector<std::uint8_t> message);
  /// Dropped if there is no connection now.
  void publish_now(std::string subject, std::vector<std::uint8_t> message);
  /// Maximum size of a message; the usual value before the first connection.
  [[nodiscard]] std::size_t max_message_bytes() const;
  [[nodiscard]] NatsStats stats() const;

 private:
  class Link;
  explicit NatsClient(std::shared_ptr<Link> link);
  std::shared_ptr<Link> link_;
};

}  // namespace roomcast::hub::federation
