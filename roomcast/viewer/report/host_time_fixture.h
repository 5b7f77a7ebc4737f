// SPDX-License-Identifier: Apache-2.0
// Times of this machine's clock for the viewer's tests.
#pragma once

#include <chrono>

#include "roomcast/core/clock.h"

namespace roomcast::viewer {

inline HostTime at(nanoseconds since_start) {
  return HostTime(std::chrono::hours(1) + since_start);
}

}  // namespace roomcast::viewer
