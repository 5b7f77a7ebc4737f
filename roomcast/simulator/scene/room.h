// SPDX-License-Identifier: Apache-2.0
// Room: a furnished room: its static mesh, lights, sensor mounts and people. World frame: metres, y
// up, floor at y = 0, origin at the centre of the floor.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "roomcast/core/result.h"
#include "roomcast/simulator/scene/footprint.h"
#include "roomcast/simulator/scene/person.h"
#include "roomcast/simulator/scene/surface.h"
#include "roomcast/simulator/scene/triangle_mesh.h"

namespace roomcast::simulator {

struct Light {
  Eigen::Vector3f position_m;
  Eigen::Vector3f power;   // linear light per channel received by one square metre at one metre
  Eigen::Vector3f facing;  // a window lights one side only; zero: all directions
  float radius_m = 0.1F;   // size of the luminous part: makes shadows soft
};

/// Position of a sensor and the point it looks at.
struct SensorMount {
  Eigen::Vector3f eye_m;
  Eigen::Vector3f target_m;
};
inline constexpr int kMaxSimulatedSensors = 8;

struct Room {
  std::string name;
  Eigen::Vector3f size_m;  // x, y (height), z
  TriangleMesh mesh;
  std::vector<Surface> surfaces;
  std::vector<Light> lights;
  Eigen::Vector3f ambient;  // linear light from all directions
  std::array<SensorMount, kMaxSimulatedSensors>
      sensor_mounts;  // any prefix of them covers the whole room
  std::vector<Person> people;
  int unique_things = -1;  // number of unique objects in a room of repetitions; -1: not such a room
  std::vector<Footprint> footprints;  // of the objects on the floor

  SurfaceIndex add(const Surface& surface) {
    surfaces.push_back(surface);
    return static_cast<SurfaceIndex>(surfaces.size() - 1);
  }
};

/// The default scene is the first.
inline constexpr std::array<std::string_view, 8> kSceneNames = {
    "livingroom", "office", "lab", "meeting", "studio", "bare", "mirror-tiles", "corners"};
/// Rooms that are harder to align than most, built by their names only: no default list has them.
inline constexpr std::array<std::string_view, 6> kHarshSceneNames = {
    "shelf-rows", "desk-rows", "half-turn-hall", "open-plan", "glossy-floor", "dark-floor"};
/// All scene names as a list for messages.
[[nodiscard]] std::string scene_list();

/// Builds a room of one kind ("": the default); each seed gives another room. kNotFound, listing
/// the scenes, for an unknown name.
[[nodiscard]] Result<Room> build_room(std::string_view scene, std::uint64_t seed);

}  // namespace roomcast::simulator
