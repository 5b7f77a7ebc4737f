// SPDX-License-Identifier: Apache-2.0
// LatencyBudget: a picture's latency from the sensor to the screen, by stage; medians of the last
// second. The time before arrival (registration, encoding, network, hub) is one stage, measured
// with the room clock and subject to that clock's error. Pure.
#pragma once

#include <chrono>
#include <deque>
#include <optional>

#include "roomcast/client/room/room_snapshot.h"

namespace roomcast::viewer {

struct LatencyStages {
  std::optional<double> to_here_ms;  // capture to arrival; empty before the clock is known
  double decoding_ms = 0;
  double waiting_ms = 0;  // for the rest of its set, and for drawing to begin
  double drawing_ms = 0;
  std::optional<double> total_ms;        // capture to drawn
  std::optional<double> clock_error_ms;  // of to_here_ms and total_ms
};

class LatencyBudget {
 public:
  static constexpr std::chrono::seconds kWindow{1};

  /// Call it when `picture` was drawn for the first time, from `begin` to `end`.
  void shown(const client::SensorPicture& picture,
             const std::optional<client::ClockEstimate>& clock, HostTime begin, HostTime end);

  /// Empty if no new picture was drawn within the window before `now`.
  [[nodiscard]] std::optional<LatencyStages> median(HostTime now) const;

 private:
  struct Passage {
    HostTime at{};
    LatencyStages stages;
  };
  std::deque<Passage> passages_;
};

}  // namespace roomcast::viewer
