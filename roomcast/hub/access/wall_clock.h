// SPDX-License-Identifier: Apache-2.0
// The time of day, for what holds by the calendar: until when a token is good. Nothing else in a
// hub asks for it. Threading: thread-safe.
#pragma once

#include <functional>

#include "roomcast/hub/access/claims.h"

namespace roomcast::hub {

using WallClock = std::function<UnixSeconds()>;

[[nodiscard]] UnixSeconds wall_time();

}  // namespace roomcast::hub
