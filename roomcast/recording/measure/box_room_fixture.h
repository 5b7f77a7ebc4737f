// SPDX-License-Identifier: Apache-2.0
// For tests: an empty room of 4 m x 5 m x 3 m with the origin at the centre of its floor, seen
// without error by sensors in its corners.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "roomcast/recording/measure/static_room.h"

namespace roomcast::recording {

inline const Eigen::Vector3d kBoxRoom_m(4, 3, 5);

/// Depth of a ray from inside the room to its walls, floor or ceiling.
inline double box_room_z_m(const RigidTransform& world_from_depth, const Eigen::Vector3d& ray) {
  const Eigen::Vector3d way = world_from_depth.rotation * ray;
  const Eigen::Vector3d& from = world_from_depth.translation_m;
  double nearest = 100;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = axis == 1 ? 0 : -kBoxRoom_m[axis] / 2;
    const double high = low + kBoxRoom_m[axis];
    if (std::abs(way[axis]) < 1e-9) continue;
    nearest = std::min(nearest, ((way[axis] > 0 ? high : low) - from[axis]) / way[axis]);
  }
  return nearest;
}

inline StaticSensor box_room_sensor(const std::string& name, const Eigen::Vector3d& eye_m,
                                    const Eigen::Vector3d& target_m) {
  StaticSensor sensor;
  sensor.name = name;
  sensor.depth = {.width = 256, .height = 212, .fx = 183, .fy = 183, .cx = 127.5, .cy = 105.5};
  sensor.world_from_depth = world_from_optical_looking_at(eye_m, target_m);
  sensor.depth_mm = DepthImage(sensor.depth.width, sensor.depth.height);
  sensor.frame_count = 1;
  for (int y = 0; y < sensor.depth.height; ++y) {
    for (int x = 0; x < sensor.depth.width; ++x) {
      const auto ray = *unproject(sensor.depth, {x, y}, 1);
      sensor.depth_mm.at(x, y) = static_cast<std::uint16_t>(
          std::lround(1000 * box_room_z_m(sensor.world_from_depth, ray)));
    }
  }
  return sensor;
}

inline std::vector<StaticSensor> box_room() {
  return {box_room_sensor("a", {-1.8, 1.8, -2.3}, {1, 1.2, 1.5}),
          box_room_sensor("b", {1.8, 1.8, 2.3}, {-1, 1.2, -1.5}),
          box_room_sensor("c", {1.8, 1.8, -2.3}, {-1, 1.2, 1.5}),
          box_room_sensor("d", {-1.8, 1.8, 2.3}, {1, 1.2, -1.5})};
}

}  // namespace roomcast::recording
