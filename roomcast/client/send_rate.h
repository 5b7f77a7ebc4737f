// SPDX-License-Identifier: Apache-2.0
// SendRate: how much of the full rate the way to the hub seems to carry, from what the sending side
// sees itself: frames pile up unsent when the network takes them more slowly than they come. Cuts
// at once, then tries a little more every second, as TCP does (additive increase, multiplicative
// decrease: Chiu and Jain 1989). Pure.
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
  static constexpr std::chrono::milliseconds kCutInterval{500};  // a cut takes time to show
  static constexpr std::chrono::seconds kRaiseInterval{1};

  /// A frame had to be left out because those before it are still unsent.
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
