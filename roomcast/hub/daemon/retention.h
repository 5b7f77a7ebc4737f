// SPDX-License-Identifier: Apache-2.0
// Retention: which recordings are deleted, because they are older than a hub keeps them, or because
// their room has more than it may. Pure. Thread-safe (no state).
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "roomcast/core/clock.h"

namespace roomcast::hub::daemon {

/// Of one room; 0: no limit.
struct RoomRetention {
  std::chrono::days max_age{0};  // since the end of a recording
  std::uint64_t max_bytes = 0;   // of all recordings together

  [[nodiscard]] bool any() const { return max_age.count() > 0 || max_bytes > 0; }
};

struct Retention {
  RoomRetention usual = {};                         // of rooms without one of their own
  std::map<std::string, RoomRetention> rooms = {};  // by name

  [[nodiscard]] const RoomRetention& of(const std::string& room) const {
    const auto found = rooms.find(room);
    return found == rooms.end() ? usual : found->second;
  }
  [[nodiscard]] bool any() const {
    return usual.any() ||
           std::ranges::any_of(rooms, [](const auto& room) { return room.second.any(); });
  }
};

struct AgingRecording {
  std::string name;
  std::string room;  // empty: it names none, so it is kept
  std::uint64_t bytes = 0;
  nanoseconds ended_at{};  // since 1970-01-01 UTC
  bool running = false;    // counts, and is kept
};

/// Those to be deleted: first the ones that are too old, then, the oldest first, until no room has
/// more than it may.
[[nodiscard]] std::vector<AgingRecording> outdated(std::vector<AgingRecording> recordings,
                                                   const Retention& retention, nanoseconds now);

}  // namespace roomcast::hub::daemon
