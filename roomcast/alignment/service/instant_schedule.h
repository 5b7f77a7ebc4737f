// SPDX-License-Identifier: Apache-2.0
// When the sensors of a room record instants: each takes the frame that follows a moment, so that
// the frames of different sensors are less than a frame's duration apart.
#pragma once

#include <chrono>
#include <cmath>

namespace roomcast::alignment {

inline constexpr std::chrono::milliseconds kInstantInterval{400};

/// The last moment before this room time, counted from the clock's beginning.
[[nodiscard]] inline long long moment_of(double room_time_s) {
  return std::llround(
      std::floor(room_time_s / std::chrono::duration<double>(kInstantInterval).count()));
}

}  // namespace roomcast::alignment
