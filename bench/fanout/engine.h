// SPDX-License-Identifier: Apache-2.0
// The servers compared by `roomcast bench fanout`. Each runs in a process of its own on 127.0.0.1
// and forwards every frame of a publisher to all viewers.
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

/// Viewers send the pose of their heads ten times a second, or not at all.
enum class Heads {
  kNotTold,
  kTold,      // without the angle of view, so that they get all frames
  kElsewhere  // they look where no sensor sees anything, and turn
};

struct FanoutRoom {
  std::size_t frame_bytes = 20'480;
  double fps = 30;  // announced by the sensors
  /// True: frames are stamped with the time at which they are sent. False, for publishers faster
  /// than any camera: frames are stamped with times long ago, and each becomes a set of its own.
  bool real_time = true;
  Heads heads = Heads::kNotTold;
};

struct RunningEngine {
  ChildProcess process;
  std::unique_ptr<Protocol> protocol;
  std::optional<net::Fingerprint> certificate;  // of servers that encrypt
};

class Engine {
 public:
  virtual ~Engine() = default;
  [[nodiscard]] virtual std::string name() const = 0;
  [[nodiscard]] virtual bool encrypts() const { return false; }
  /// kUnavailable: the server does not start. kNotFound: it is not installed.
  [[nodiscard]] virtual Result<RunningEngine> start(const FanoutRoom& room) const = 0;
};

/// The lower bound: epoll and send(), or SSL_write(), and nothing else.
[[nodiscard]] std::unique_ptr<Engine> make_socket_loop(bool tls);
/// `roomcast hub`.
[[nodiscard]] std::unique_ptr<Engine> make_hub(bool tls);
/// WebSocket streams of Boost.Beast with default settings, which cut a message into 4 KB pieces.
[[nodiscard]] std::unique_ptr<Engine> make_beast();
/// Message brokers, where they are installed.
[[nodiscard]] std::unique_ptr<Engine> make_nats();
[[nodiscard]] std::unique_ptr<Engine> make_redis();
[[nodiscard]] std::unique_ptr<Engine> make_mosquitto();

}  // namespace roomcast::bench
