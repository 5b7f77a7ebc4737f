// SPDX-License-Identifier: Apache-2.0
// IDs of the virtual connections of a backplane, which speak for sensors and hubs elsewhere. They
// belong to no shard and have the highest bit set.
#pragma once

#include <cstdint>

#include "roomcast/core/ids.h"

namespace roomcast::hub {

inline constexpr std::uint64_t kBackplaneBit = std::uint64_t{1} << 63;

/// The ID of a backplane's connection. `owner` below 2^31 is free for the backplane's own use.
[[nodiscard]] inline ConnectionId backplane_connection(std::uint32_t owner, std::uint32_t number) {
  return ConnectionId{kBackplaneBit | std::uint64_t{owner} << 32 | number};
}
[[nodiscard]] inline bool is_of_backplane(ConnectionId connection) {
  return (connection.value & kBackplaneBit) != 0;
}
[[nodiscard]] inline std::uint32_t backplane_owner(ConnectionId connection) {
  return static_cast<std::uint32_t>((connection.value & ~kBackplaneBit) >> 32);
}

}  // namespace roomcast::hub
