// SPDX-License-Identifier: Apache-2.0
// The walls of a room, from what stands still in it. A wall is an upright plane that is seen over a
// good area and behind which hardly anything is seen: that tells it from a cupboard.
//   1. upright surface points, seen from above: place and direction, weighted by how well they are
//      known
//   2. lines through single points with their directions are tried (RANSAC, Fischler & Bolles 1981,
//      in a fixed order); the one that covers most area is fitted by least squares and its points
//      are taken away, until what is left is small
//   3. lines with things behind them are furniture, and so are those with a larger wall close
//   behind
//   4. walls that nearly meet are led to their corner
// World frame: plan coordinates are (x, z), metres. Thread-safe (no state).
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "roomcast/recording/measure/static_room.h"

namespace roomcast::recording {

/// A point of an upright surface.
struct UprightPoint {
  Eigen::Vector2d plan_m;
  Eigen::Vector2d normal;  // unit, towards the sensor
  double height_m = 0;
  double weight = 1;  // 1 / variance
};

struct Wall {
  Eigen::Vector2d from_m, to_m;  // plan
  Eigen::Vector2d normal;        // into the room
  double area_m2 = 0;            // that was seen

  [[nodiscard]] double length_m() const { return (to_m - from_m).norm(); }
  [[nodiscard]] double offset_m() const { return normal.dot(from_m); }
};

/// Those between kLowest_m and kHighest_m above the floor, which lies at y = 0.
inline constexpr double kLowest_m = 0.1, kHighest_m = 2.6;
[[nodiscard]] std::vector<UprightPoint> upright_points(std::span<const StaticSensor> room);

/// Largest first.
[[nodiscard]] std::vector<Wall> find_walls(std::span<const UprightPoint> points);

}  // namespace roomcast::recording
