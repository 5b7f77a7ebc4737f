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

constexpr std::array<TryBuild, kHarshSceneNames.size()> kTryBuildHarsh = {
    try_shelf_rows, try_desk_rows,    try_half_turn_hall,
    try_open_plan,  try_glossy_floor, try_dark_floor};

/// Nothing for an unknown name.
TryBuild builder_of(std::string_view scene) {
  const auto known = std::find(kSceneNames.begin(), kSceneNames.end(), scene);
  if (known != kSceneNames.end())
    return kTryBuild[static_cast<std::size_t>(known - kSceneNames.begin())];
  const auto harsh = std::find(kHarshSceneNames.begin(), kHarshSceneNames.end(), scene);
  if (harsh == kHarshSceneNames.end()) return nullptr;
  return kTryBuildHarsh[static_cast<std::size_t>(harsh - kHarshSceneNames.begin())];
}

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
    if (!list.empty()) list += ", ";
    list += name;
  }
  for (const std::string_view name : kHarshSceneNames) {
    list += name == kHarshSceneNames.back() ? " and " : ", ";
    list += name;
  }
  return list;
}

Result<Room> build_room(std::string_view scene, std::uint64_t seed) {
  const auto folded =
      hash_of(static_cast<std::uint32_t>(seed >> 32), static_cast<std::uint32_t>(seed));
  const std::string_view wanted = scene.empty() ? kSceneNames.front() : scene;
  if (const TryBuild try_build = builder_of(wanted)) {
    Room room = first_that_fits(try_build, folded);
    room.name = wanted;
    return room;
  }
  return Error{ErrorCode::kNotFound, "There is no simulated scene \"" + std::string(scene) +
                                         "\"; the scenes are " + scene_list() + "."};
}

}  // namespace roomcast::simulator
