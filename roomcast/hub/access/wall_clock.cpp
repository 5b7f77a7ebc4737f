// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/access/wall_clock.h"

#include <chrono>

namespace roomcast::hub {

UnixSeconds wall_time() {
  return std::chrono::duration_cast<std::chrono::seconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

}  // namespace roomcast::hub
