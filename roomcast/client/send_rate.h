// SPDX-License-Identifier: Apache-2.0
// SendRate: estimates the share of the full rate that the connection to the hub carries, on the
// sending side only: frames queue up when the network is slower than the source. Cuts at once, then
// raises a little every second, as TCP does (additive increase, multiplicative decrease: Chiu and
// Jain 1989). No I/O.
#pragma once

#include <algorithm>
#include <chrono>
#include <optional>

#include "roomcast/core/clock.h"

namespace roomcast::client {

class SendRate {
 public:
  static constexpr double kMinShare = 0.2;
  static constexpr double kCut = 0.7, kRaise = 0.05;
  static constexpr std::chrono::milliseconds kCutInterval{500};  // time for a cut to take effect
  static constexpr std::chrono::seconds kRaiseInterval{1};

  /// A frame was skipped because earlier ones are still unsent.
  void piled_up(HostTime now) {
    if (last_cut_ && now < *last_cut_ + kCutInterval) {
      last_change_ = now;
      return;
    }
    share_ = std::max(kMinShare, share_ * kCut);
    last_cut_ = last_change_ = now;
  }

  /// A frame could be sent.
  void flowed(HostTime now) {
    if (share_ >= 1 || now < last_change_ + kRaiseInterval) return;
    share_ = std::min(1.0, share_ + kRaise);
    last_change_ = now;
  }

  /// Of the full rate, kMinShare..1.
  [[nodiscard]] double share() const { return share_; }

 private:
  double share_ = 1;
  std::optional<HostTime> last_cut_;
  HostTime last_change_{};
};

}  // namespace roomcast::client
