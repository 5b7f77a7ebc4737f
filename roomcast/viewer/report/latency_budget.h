// SPDX-License-Identifier: Apache-2.0
// LatencyBudget: how long a picture takes from the sensor to the screen, and where. Medians of the
// last second. What happens before a picture arrives (registration, encoding, the network, the hub)
// is one stage: it is told by the hub's clock, with that clock's error. Pure.
#pragma once

#include <chrono>
#include <deque>
#include <optional>

#include "roomcast/client/room/room_snapshot.h"

namespace roomcast::viewer {

struct LatencyStages {
  std::optional<double> to_here_ms;  // capture to arrival; nothing before the clock is known
  double decoding_ms = 0;
  double waiting_ms = 0;  // for the rest of its set, and for the drawing to begin
  double drawing_ms = 0;
  std::optional<double> total_ms;        // capture to drawn
  std::optional<double> clock_error_ms;  // of the first and of the total
};

class LatencyBudget {
 public:
  static constexpr std::chrono::seconds kWindow{1};

  /// `picture` was drawn for the first time, from `begin` to `end`.
  void shown(const client::SensorPicture& picture, const std::optional<client::ClockEstimate>& clock,
             HostTime begin, HostTime end);

  /// Nothing when no new picture was drawn within the window before `now`.
  [[nodiscard]] std::optional<LatencyStages> median(HostTime now) const;

 private:
  struct Passage {
    HostTime at{};
    LatencyStages stages;
  };
  std::deque<Passage> passages_;
};

}  // namespace roomcast::viewer
