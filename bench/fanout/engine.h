// SPDX-License-Identifier: Apache-2.0
// The servers that `roomcast bench fanout` compares. Each runs in a process of its own on
// 127.0.0.1 and hands every frame that a publisher sends to all viewers.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/fanout/child_process.h"
#include "bench/fanout/protocol.h"
#include "roomcast/core/result.h"
#include "roomcast/net/tls/fingerprint.h"

namespace roomcast::bench {

struct FanoutRoom {
  std::size_t frame_bytes = 20'480;
  double fps = 30;  // that sensors announce
  /// Frames are stamped with the moment at which they are sent. Else, for those who send faster
  /// than any camera, with one of long ago: each is then a set of its own.
  bool real_time = true;
};

struct RunningEngine {
  ChildProcess process;
  std::unique_ptr<Protocol> protocol;
  std::optional<net::Fingerprint> certificate;  // of those that encrypt
};

class Engine {
 public:
  virtual ~Engine() = default;
  [[nodiscard]] virtual std::string name() const = 0;
  [[nodiscard]] virtual bool encrypts() const { return false; }
  /// kUnavailable: it does not start. kNotFound: it is not installed.
  [[nodiscard]] virtual Result<RunningEngine> start(const FanoutRoom& room) const = 0;
};

/// The limit: epoll and send(), or SSL_write(), and nothing else.
[[nodiscard]] std::unique_ptr<Engine> make_socket_loop(bool tls);
/// `roomcast hub`.
[[nodiscard]] std::unique_ptr<Engine> make_hub(bool tls);
/// WebSocket streams of Boost.Beast as they come, which cut a message into 4 KB pieces.
[[nodiscard]] std::unique_ptr<Engine> make_beast();
/// Message brokers of others, where they are installed.
[[nodiscard]] std::unique_ptr<Engine> make_nats();
[[nodiscard]] std::unique_ptr<Engine> make_redis();
[[nodiscard]] std::unique_ptr<Engine> make_mosquitto();

}  // namespace roomcast::bench
