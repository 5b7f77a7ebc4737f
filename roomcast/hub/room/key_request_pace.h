// SPDX-License-Identifier: Apache-2.0
// KeyRequestPace: limits the key requests to one sensor to one per wire::kKeyRequestInterval.
// Requests in between are merged into one. The arrival of a key frame answers all of them. Pure.
#pragma once

#include <optional>

#include "roomcast/core/clock.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub {

class KeyRequestPace {
 public:
  /// Records that a viewer needs a key frame. True: send a key request to the sensor now.
  bool request(RoomTime now) {
    wanted_ = true;
    return due(now);
  }

  /// True: send the pending key request to the sensor now.
  bool due(RoomTime now) {
    if (!wanted_ || (last_ && now < *last_ + wire::kKeyRequestInterval)) return false;
    wanted_ = false;
    last_ = now;
    return true;
  }

  void key_frame_came() { wanted_ = false; }

  /// The time from which due() returns true; nothing: no request is pending.
  [[nodiscard]] std::optional<RoomTime> next() const {
    if (!wanted_) return std::nullopt;
    return last_ ? *last_ + wire::kKeyRequestInterval : RoomTime{};
  }

 private:
  std::optional<RoomTime> last_;
  bool wanted_ = false;
};

}  // namespace roomcast::hub
