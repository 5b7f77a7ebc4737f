// SPDX-License-Identifier: Apache-2.0
// KeyRequestPace: at most one key request per sensor and kKeyRequestInterval; those in between are
// remembered and become one. A key frame that comes answers all of them. Pure.
#pragma once

#include <optional>

#include "roomcast/core/clock.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub {

class KeyRequestPace {
 public:
  /// Someone needs a key frame. True: ask the sensor now.
  bool request(RoomTime now) {
    wanted_ = true;
    return due(now);
  }

  /// True: ask the sensor now, on behalf of a remembered request.
  bool due(RoomTime now) {
    if (!wanted_ || (last_ && now < *last_ + wire::kKeyRequestInterval)) return false;
    wanted_ = false;
    last_ = now;
    return true;
  }

  void key_frame_came() { wanted_ = false; }

  /// When due() will be true; nothing while no request waits.
  [[nodiscard]] std::optional<RoomTime> next() const {
    if (!wanted_) return std::nullopt;
    return last_ ? *last_ + wire::kKeyRequestInterval : RoomTime{};
  }

 private:
  std::optional<RoomTime> last_;
  bool wanted_ = false;
};

}  // namespace roomcast::hub
