// SPDX-License-Identifier: Apache-2.0
// Draws a room from above: its walls, its furniture (occupied cells) and its sensors, as a picture
// with a scale (SVG 1.1; 1 unit is 1 cm). World frame seen from +y: x to the right, z down.
// Thread-safe (no state).
#pragma once

#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "roomcast/core/result.h"
#include "roomcast/recording/measure/static_room.h"
#include "roomcast/recording/measure/wall_finder.h"

namespace roomcast::recording {

struct FloorPlan {
  std::vector<Wall> walls;
  std::vector<Eigen::Vector2i> taken_cells;  // kPlanCell_m wide, indexed by x and z
  std::vector<StaticSensor> sensors;         // without their pictures
};
inline constexpr double kPlanCell_m = 0.04;

/// kNotFound if no wall is found.
[[nodiscard]] Result<FloorPlan> draw_floor_plan(std::span<const StaticSensor> room);

[[nodiscard]] std::string floor_plan_svg(const FloorPlan& plan, const std::string& title);

}  // namespace roomcast::recording
