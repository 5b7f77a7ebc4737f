// SPDX-License-Identifier: Apache-2.0
// Which capture times a program may give for its frames. Others come from another clock than the
// host's.
#pragma once

#include <chrono>

#include "roomcast/core/clock.h"

namespace roomcast::sensor {

/// True for times of the last ten seconds, and up to half a second ahead.
[[nodiscard]] inline bool is_recent(HostTime capture_time, HostTime now) {
  return capture_time >= now - std::chrono::seconds(10) &&
         capture_time <= now + std::chrono::milliseconds(500);
}

}  // namespace roomcast::sensor
