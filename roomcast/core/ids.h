// SPDX-License-Identifier: Apache-2.0
// Ids are types: a SensorId cannot be passed where a ViewerId is meant.
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

/// One room of a hub. Never used twice while a hub runs.
using RoomId = Id<struct RoomTag, std::uint32_t>;
/// A sensor of one room. Given by the hub, kept by the sensor's name when it comes back.
using SensorId = Id<struct SensorTag, std::uint16_t>;
/// A person's program in one room. Never used twice while a hub runs.
using ViewerId = Id<struct ViewerTag, std::uint32_t>;
/// One accepted connection of a hub. Never used twice while a hub runs.
using ConnectionId = Id<struct ConnectionTag, std::uint64_t>;
/// One instant of a room, at the room's frame rate. Grows.
using SetId = Id<struct SetTag, std::uint64_t>;

}  // namespace roomcast

template <class Tag, class Rep>
struct std::hash<roomcast::Id<Tag, Rep>> {
  std::size_t operator()(roomcast::Id<Tag, Rep> id) const noexcept {
    return std::hash<Rep>{}(id.value);
  }
};
