// SPDX-License-Identifier: Apache-2.0
// A furnished room: what stands still in it, how it is lit, where sensors stand, and who walks in
// it. World frame: metres, y up, floor at y = 0, the origin in the middle of the floor.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "roomcast/core/clock.h"
#include "roomcast/core/result.h"
#include "roomcast/source/simulator/scene/surface.h"
#include "roomcast/source/simulator/scene/triangle_mesh.h"

namespace roomcast::sim {

struct Light {
  Eigen::Vector3f position_m;
  Eigen::Vector3f power;   // linear light per channel that one square metre gets at one metre
  Eigen::Vector3f facing;  // a window lights one side only; zero: every direction
  float radius_m = 0.1F;   // size of what glows: makes shadows soft
};

/// Where a sensor stands and what it looks at.
struct SensorStand {
  Eigen::Vector3f eye_m;
  Eigen::Vector3f target_m;
};
inline constexpr int kMaxSimulatedSensors = 8;

/// A closed walk round an ellipse on the floor.
struct Walk {
  Eigen::Vector2f centre_m;  // x, z
  Eigen::Vector2f radii_m;
  nanoseconds lap{};
  int strides_per_lap = 5;  // a stride is two steps
};

/// What the walking person wears.
struct Clothes {
  Surface shirt, trousers, shoes, skin, hair, face;
};

struct Room {
  std::string name;
  Eigen::Vector3f size_m;  // x, y (height), z
  TriangleMesh mesh;
  std::vector<Surface> surfaces;
  std::vector<Light> lights;
  Eigen::Vector3f ambient;                               // light from everywhere, linear
  std::array<SensorStand, kMaxSimulatedSensors> stands;  // any first few of them see the whole room
  Walk walk;
  Clothes clothes;

  SurfaceIndex add(const Surface& surface) {
    surfaces.push_back(surface);
    return static_cast<SurfaceIndex>(surfaces.size() - 1);
  }
};

/// "livingroom" ("" too) or "office", its things varied by the seed. kNotFound, listing the scenes,
/// for another name.
[[nodiscard]] Result<Room> build_room(std::string_view scene, std::uint64_t seed);

}  // namespace roomcast::sim
