// SPDX-License-Identifier: Apache-2.0
// SimulatedClocks: a host, a hub and a slow network between them, for tests of ClockSync. The
// host's frames leave at a fixed rate and occupy the link for a while; a ping that leaves meanwhile
// waits. Times are true seconds; the two clocks differ by `offset_s` and drift apart. No I/O;
// seeded.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "roomcast/client/clock_sync.h"

namespace roomcast::client {

struct SimulatedNetwork {
  double one_way_s = 0.025;
  double frame_period_s = 1.0 / 30;
  double frame_on_the_way_s = 0.008;  // 20 KB at 20 Mbit/s; 0: no frames
  double wake_up_s = 10e-6;           // mean wake-up time of a program after a message
  double outlier_share = 0.01, outlier_s = 0.2;
};

class SimulatedClocks {
 public:
  SimulatedClocks(const SimulatedNetwork& network, double offset_s, double drift)
      : network_(network), offset_s_(offset_s), drift_(drift) {}

  [[nodiscard]] static HostTime host(double true_s) {
    return HostTime(nanoseconds(static_cast<std::int64_t>(true_s * 1e9)));
  }
  [[nodiscard]] RoomTime room(double true_s) const {
    return RoomTime(
        nanoseconds(static_cast<std::int64_t>((true_s * (1 + drift_) + offset_s_) * 1e9)));
  }
  /// Sets the hub's clock forward.
  void step(double by_s) { offset_s_ += by_s; }

  /// Simulates a ping that leaves at `sent_s`; returns the time of its answer.
  double ping(ClockSync& sync, double sent_s) {
    const double hub_s = sent_s + wait_behind_frame(sent_s) + way_s();
    const double received_s = hub_s + way_s();
    sync.add(host(sent_s), room(hub_s), host(received_s));
    return received_s;
  }

  /// The error of the estimate for a frame captured at `true_s`.
  [[nodiscard]] double error_s(const ClockEstimate& estimate, double true_s) const {
    const nanoseconds error = estimate.room_time(host(true_s)) - room(true_s);
    return std::abs(static_cast<double>(error.count()) * 1e-9);
  }

 private:
  [[nodiscard]] double wait_behind_frame(double at_s) const {
    const double since_frame_s = std::fmod(at_s, network_.frame_period_s);
    return std::max(0.0, network_.frame_on_the_way_s - since_frame_s);
  }
  double way_s() {
    const bool is_outlier = share_(random_) < network_.outlier_share;
    return network_.one_way_s + wake_up_(random_) * network_.wake_up_s +
           (is_outlier ? share_(random_) * network_.outlier_s : 0);
  }

  SimulatedNetwork network_;
  double offset_s_, drift_;
  std::minstd_rand random_{7};
  std::uniform_real_distribution<double> share_{0, 1};
  std::exponential_distribution<double> wake_up_{1};
};

}  // namespace roomcast::client
