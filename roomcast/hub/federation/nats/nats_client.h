// SPDX-License-Identifier: Apache-2.0
// NatsClient: a hub's connection to a NATS cluster (docs.nats.io). When the node it is connected to
// is gone or hangs, it goes on at another one; what was said meanwhile may be lost, as always with
// NATS.
//
// Threading: made, used and destroyed on the thread that runs `io`, where the handlers are called;
// only open() waits.
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

/// Since it was opened.
struct NatsStats {
  bool is_connected = false;
  hub::BackplaneTraffic sent = {}, received = {};
  std::uint64_t dropped = 0;  // messages: there was no connection, or a slow one
};

struct NatsHandlers {
  /// Not to destroy the client.
  std::function<void(std::string_view subject, std::span<const std::uint8_t> message)> on_message;
  /// Connected, perhaps to another node than before.
  std::function<void()> on_connected;
  LogSink log;
};

class NatsClient {
 public:
  /// No more waits to be written; what is more is dropped.
  static constexpr std::size_t kMaxWaitingBytes = 8u << 20;

  /// Waits for the first connection, at most kConnectWithin for each server; where none answers it
  /// goes on trying. Errors of check() and log_in_to_nats().
  static Result<std::unique_ptr<NatsClient>> open(NatsOptions options, boost::asio::io_context& io,
                                                  NatsHandlers handlers);
  ~NatsClient();

  void subscribe(std::string subject);
  void unsubscribe(const std::string& subject);
  /// Said later where there is no connection now.
  void publish(std::string subject, std::vector<std::uint8_t> message);
  /// Now or never.
  void publish_now(std::string subject, std::vector<std::uint8_t> message);
  /// What a message may have. As usual, while there was no connection yet.
  [[nodiscard]] std::size_t max_message_bytes() const;
  [[nodiscard]] NatsStats stats() const;

 private:
  class Link;
  explicit NatsClient(std::shared_ptr<Link> link);
  std::shared_ptr<Link> link_;
};

}  // namespace roomcast::hub::federation
