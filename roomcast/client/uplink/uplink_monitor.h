// SPDX-License-Identifier: Apache-2.0
// UplinkMonitor: watches a client's connection to its hub, estimates the rate that its line
// carries, and has the kernel send at a pace a little above. Threading: lives on the network
// thread; uplink() is thread-safe.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

#include <boost/asio/io_context.hpp>

#include "roomcast/client/uplink/bandwidth_estimator.h"
#include "roomcast/client/uplink/uplink.h"
#include "roomcast/core/clock.h"
#include "roomcast/net/line_state.h"
#include "roomcast/net/timer.h"

namespace roomcast::client {

class UplinkMonitor {
 public:
  /// The connection that is watched, whichever it is at the moment.
  struct Line {
    std::function<std::optional<net::LineState>()> state;
    std::function<void(double payload_bytes_per_s)> set_pace;
  };
  UplinkMonitor(boost::asio::io_context& io, Line line) : line_(std::move(line)), timer_(io) {}

  /// There is a new connection: what its line carries is unknown, and the last line's rate a guess
  /// that is too good.
  void start();
  void stop() { timer_.cancel(); }
  /// For good.
  void finish() { timer_.stop(); }

  /// By the newest reading; what waits for this connection to take it is not counted.
  [[nodiscard]] Uplink uplink() const { return {bytes_per_s_, unsent_bytes_}; }

 private:
  void read();

  const Line line_;
  net::Timer timer_;
  SteadyClock clock_;
  BandwidthEstimator estimator_;
  std::atomic<double> bytes_per_s_ = BandwidthEstimator::kStart;
  std::atomic<std::size_t> unsent_bytes_ = 0;
};

}  // namespace roomcast::client
