// SPDX-License-Identifier: Apache-2.0
// Finds the walls of a room in its static surfaces. A wall is a vertical plane with a large visible
// area and almost no surface behind it; the latter distinguishes it from a cupboard.
//    1. Project vertical surface points onto the floor: position and direction, weighted by
//       accuracy.
//    2. Try lines through single points with their directions (RANSAC, Fischler & Bolles 1981, in a
//       fixed order); fit the one that covers most area by least squares and remove its points;
//       repeat until the remainder is small.
//    3. Reject lines with surface behind them, and lines with a larger wall close behind:
//       furniture.
//    4. Extend walls that nearly meet to their corner.
// World frame: plan coordinates are (x, z), metres. Thread-safe (no state).
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "roomcast/recording/measure/static_room.h"

namespace roomcast::recording {

/// A point of a vertical surface.
struct UprightPoint {
  Eigen::Vector2d plan_m;
  Eigen::Vector2d normal;  // unit, towards the sensor
  double height_m = 0;
  double weight = 1;  // 1 / variance
};

struct Wall {
  Eigen::Vector2d from_m, to_m;  // plan
  Eigen::Vector2d normal;        // into the room
  double area_m2 = 0;            // observed area

  [[nodiscard]] double length_m() const { return (to_m - from_m).norm(); }
  [[nodiscard]] double offset_m() const { return normal.dot(from_m); }
};

/// Height range of the points used, above the floor at y = 0.
inline constexpr double kLowest_m = 0.1, kHighest_m = 2.6;
[[nodiscard]] std::vector<UprightPoint> upright_points(std::span<const StaticSensor> room);

/// Returns the walls, largest first.
[[nodiscard]] std::vector<Wall> find_walls(std::span<const UprightPoint> points);

}  // namespace roomcast::recording
