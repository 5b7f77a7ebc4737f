// SPDX-License-Identifier: Apache-2.0
// FrameDemand: decides whether the sensors of a room should send frames: while somebody watches,
// and for some seconds after, so that a viewer who reloads the page does not stop and restart them.
// Pure.
#pragma once

#include <chrono>
#include <optional>

#include "roomcast/core/clock.h"

namespace roomcast::hub {

class FrameDemand {
 public:
  /// Sensors send for so long after the last viewer has left.
  static constexpr std::chrono::seconds kKeptUnwatched{5};

  /// Takes whether somebody watches now. True: wanted() has changed.
  bool update(bool is_watched, RoomTime now) {
    const bool was_wanted = wanted_;
    if (is_watched) {
      wanted_ = true;
      ends_.reset();
    } else if (wanted_) {
      if (!ends_) ends_ = now + kKeptUnwatched;
      if (now >= *ends_) {
        wanted_ = false;
        ends_.reset();
      }
    }
    return wanted_ != was_wanted;
  }

  [[nodiscard]] bool wanted() const { return wanted_; }
  /// The time for the next update() if nothing else happens before; nothing: none is needed.
  [[nodiscard]] std::optional<RoomTime> next() const { return ends_; }

 private:
  bool wanted_ = false;
  std::optional<RoomTime> ends_;
};

}  // namespace roomcast::hub
