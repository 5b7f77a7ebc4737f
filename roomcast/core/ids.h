// SPDX-License-Identifier: Apache-2.0
// IDs are distinct types: a SensorId cannot be passed where a ViewerId is expected.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace roomcast {

template <class Tag, class Rep>
struct Id {
  Rep value{};
  friend constexpr auto operator<=>(const Id&, const Id&) = default;
};

/// One room of a hub. Not reused while the hub runs.
using RoomId = Id<struct RoomTag, std::uint32_t>;
/// A sensor of one room. Assigned by the hub; a sensor that reconnects under the same name keeps
/// it.
using SensorId = Id<struct SensorTag, std::uint16_t>;
/// A viewer in one room. Not reused while the hub runs.
using ViewerId = Id<struct ViewerTag, std::uint32_t>;
/// One accepted connection of a hub. Not reused while the hub runs.
using ConnectionId = Id<struct ConnectionTag, std::uint64_t>;
/// One frame set of a room, at the room's frame rate. Increases over time.
using SetId = Id<struct SetTag, std::uint64_t>;

}  // namespace roomcast

template <class Tag, class Rep>
struct std::hash<roomcast::Id<Tag, Rep>> {
  std::size_t operator()(roomcast::Id<Tag, Rep> id) const noexcept {
    return std::hash<Rep>{}(id.value);
  }
};
