// SPDX-License-Identifier: Apache-2.0
// DelayEstimate: how late packets of a speaker arrive, and how long to wait for them; as in
// web/src/voice/delay_estimate.ts. Only differences count, so capture and arrival may be by
// different clocks. Source: adaptive playout after Ramjee et al., "Adaptive playout mechanisms for
// packetized audio applications in wide-area networks" (INFOCOM 1994), with a percentile of the
// lateness instead of its variance. Single-threaded.
#pragma once

#include <array>
#include <cstddef>

#include "roomcast/core/clock.h"

namespace roomcast::voice {

class DelayEstimate {
 public:
  static constexpr double kMin_ms = 20, kMax_ms = 200, kFirst_ms = 40;

  void arrived(nanoseconds capture, nanoseconds now);

  /// The shortest way of late, arrival - capture.
  [[nodiscard]] double shortest_ms() const;
  /// How much longer than that to wait.
  [[nodiscard]] double target_ms() const { return target_ms_; }

 private:
  static constexpr std::size_t kWindow = 250;  // packets
  static constexpr double kUnknown = 1e18;

  void lower();

  double target_ms_ = kFirst_ms;
  std::array<float, kWindow> lateness_{};
  std::size_t count_ = 0;
  double least_ = kUnknown, least_before_ = kUnknown;  // arrival - capture, ms
  double begun_ms_ = -kUnknown;
};

}  // namespace roomcast::voice
