// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/uplink/uplink_monitor.h"

#include <chrono>

namespace roomcast::client {
namespace {

constexpr std::chrono::milliseconds kReadEvery{20};
// Frames leave in less than the time until the next, so that the line shows whether it has more.
// BBR itself measures the line only by what is sent. Where the line has a queue, more than the rate
// would only make it longer.
constexpr double kPaceMargin = 1.5, kPaceMarginWithBbr = 1.6;

}  // namespace

void UplinkMonitor::start() {
  estimator_ = {};
  bytes_per_s_ = estimator_.bytes_per_s();
  unsent_bytes_ = 0;
  timer_.repeat(kReadEvery, [this] { read(); });
}

void UplinkMonitor::read() {
  const auto line = line_.state();
  if (!line) return;
  estimator_.add({.time = clock_.now(),
                  .delivered_bytes = line->delivered_bytes,
                  .is_waiting = line->unsent_bytes > 0,
                  .round_trip = line->round_trip,
                  .bbr_bytes_per_s = line->bbr_bytes_per_s,
                  .is_probing_round_trip = line->is_probing_round_trip,
                  .resent_packets = line->resent_packets});
  bytes_per_s_ = estimator_.bytes_per_s();
  unsent_bytes_ = line->unsent_bytes;
  line_.set_pace(estimator_.pace(line->bbr_bytes_per_s > 0 ? kPaceMarginWithBbr : kPaceMargin));
}

}  // namespace roomcast::client
