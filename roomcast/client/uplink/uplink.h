// SPDX-License-Identifier: Apache-2.0
// The line from a client to its hub, by estimate.
#pragma once

#include <cstddef>

namespace roomcast::client {

struct Uplink {
  double bytes_per_s = 0;         // that it carries, without headers of TCP and IP
  std::size_t waiting_bytes = 0;  // that are not sent yet
};

}  // namespace roomcast::client
