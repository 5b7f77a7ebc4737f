// SPDX-License-Identifier: Apache-2.0
// A furnished room: what stands still in it, how it is lit, where sensors stand, and who is
// in it. World frame: metres, y up, floor at y = 0, the origin in the middle of the floor.
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
  Eigen::Vector3f power;   // linear light per channel that one square metre gets at one metre
  Eigen::Vector3f facing;  // a window lights one side only; zero: every direction
  float radius_m = 0.1F;   // size of what glows: makes shadows soft
};

/// Where a sensor stands and what it looks at.
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
  Eigen::Vector3f ambient;  // light from everywhere, linear
  std::array<SensorMount, kMaxSimulatedSensors>
      sensor_mounts;  // any first few of them see the whole room
  std::vector<Person> people;
  int unique_things = -1;  // of a room made of repetitions: what is there once; -1: no such room
  std::vector<Footprint> footprints;  // of what stands on the floor

  SurfaceIndex add(const Surface& surface) {
    surfaces.push_back(surface);
    return static_cast<SurfaceIndex>(surfaces.size() - 1);
  }
};

/// The default comes first.
inline constexpr std::array<std::string_view, 8> kSceneNames = {
    "livingroom", "office", "lab", "meeting", "studio", "bare", "mirror-tiles", "corners"};
/// Their names as part of a sentence.
[[nodiscard]] std::string scene_list();

/// A room of one kind ("": the default), another one for every seed. kNotFound, listing the scenes,
/// for another name.
[[nodiscard]] Result<Room> build_room(std::string_view scene, std::uint64_t seed);

}  // namespace roomcast::simulator
