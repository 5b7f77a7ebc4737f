// SPDX-License-Identifier: Apache-2.0
// The calendar time, used by a hub only for the validity of tokens. Threading: thread-safe.
#pragma once

#include <functional>

#include "roomcast/hub/access/claims.h"

namespace roomcast::hub {

using WallClock = std::function<UnixSeconds()>;

[[nodiscard]] UnixSeconds wall_time();

}  // namespace roomcast::hub
