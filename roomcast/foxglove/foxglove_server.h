// SPDX-License-Identifier: Apache-2.0
// FoxgloveServer: serves topics to Foxglove, Lichtblick and other clients of foxglove.websocket.v1.
// It has a thread of its own. Messages of topics are handed over in a mailbox for each channel, the
// newest replacing the one before, so a slow client or a busy network delays nobody and memory is
// bounded. Threading: thread-safe.
#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "roomcast/core/log.h"
#include "roomcast/core/result.h"
#include "roomcast/foxglove/protocol.h"

namespace roomcast::foxglove {

struct FoxgloveServerOptions {
  std::string address = "127.0.0.1";  // numeric
  std::uint16_t port = 8765;          // 0: any free one
  std::string name = "roomcast";      // shown by clients
  std::size_t max_clients = 16;       // more are dropped
  /// Sites whose pages may connect, "https://app.example.org", besides those served by this
  /// computer. "file://" are programs made of pages, such as the desktop app.
  std::vector<std::string> origins = {"https://app.foxglove.dev", "file://"};
  LogSink log = {};
};

class FoxgloveServer {
 public:
  /// Listens and serves at once. kInvalidArgument: not an address; kUnavailable: the port is in
  /// use, or not permitted.
  static Result<std::unique_ptr<FoxgloveServer>> listen(FoxgloveServerOptions options);
  /// Ends all connections.
  ~FoxgloveServer();

  [[nodiscard]] std::uint16_t port() const;

  /// Replaces the list: clients are told what is new and what is no longer there.
  void set_channels(std::vector<Channel> channels);
  /// Those to which a client subscribes now.
  [[nodiscard]] std::set<ChannelId> wanted() const;
  /// `time`: since 1970-01-01 UTC.
  void publish(ChannelId channel, nanoseconds time, std::string message);

 private:
  class Loop;
  explicit FoxgloveServer(std::unique_ptr<Loop> loop);
  std::unique_ptr<Loop> loop_;
};

/// Whether a page of `origin` may connect: it is one of `known`, or was served by this computer.
[[nodiscard]] bool allows_origin(std::string_view origin, const std::vector<std::string>& known);

}  // namespace roomcast::foxglove
