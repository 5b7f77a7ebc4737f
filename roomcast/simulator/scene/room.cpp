// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/scene/room.h"

#include <algorithm>
#include <array>

#include "roomcast/core/assert.h"
#include "roomcast/simulator/random/value_noise.h"
#include "roomcast/simulator/scene/scenes.h"

namespace roomcast::simulator {
namespace {

using TryBuild = std::optional<Room> (*)(std::uint32_t seed);

constexpr std::array<TryBuild, kSceneNames.size()> kTryBuild = {
    try_livingroom, try_office, try_lab,          try_meeting,
    try_studio,     try_bare,   try_mirror_tiles, try_corners};

/// Some seeds leave no space for an object that a scene requires; then a derived seed is tried.
Room first_that_fits(TryBuild try_build, std::uint32_t seed) {
  constexpr std::uint32_t kMaxTries = 200;
  for (std::uint32_t i = 0; i < kMaxTries; ++i) {
    if (auto room = try_build(i == 0 ? seed : hash_of(seed, i))) return *std::move(room);
  }
  ROOMCAST_ASSERT(false);
  return {};
}

}  // namespace

std::string scene_list() {
  std::string list;
  for (const std::string_view name : kSceneNames) {
    if (!list.empty()) list += name == kSceneNames.back() ? " and " : ", ";
    list += name;
  }
  return list;
}

Result<Room> build_room(std::string_view scene, std::uint64_t seed) {
  const auto folded =
      hash_of(static_cast<std::uint32_t>(seed >> 32), static_cast<std::uint32_t>(seed));
  const std::string_view wanted = scene.empty() ? kSceneNames.front() : scene;
  const auto found = std::find(kSceneNames.begin(), kSceneNames.end(), wanted);
  if (found != kSceneNames.end()) {
    const auto which = static_cast<std::size_t>(found - kSceneNames.begin());
    Room room = first_that_fits(kTryBuild[which], folded);
    room.name = wanted;
    return room;
  }
  return Error{ErrorCode::kNotFound, "There is no simulated scene \"" + std::string(scene) +
                                         "\"; the scenes are " + scene_list() + "."};
}

}  // namespace roomcast::simulator
