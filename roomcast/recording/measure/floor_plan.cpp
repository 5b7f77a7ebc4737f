// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/measure/floor_plan.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <utility>

#include <Eigen/Geometry>

#include "roomcast/recording/export/depth_points.h"

namespace roomcast::recording {
namespace {

constexpr double kUnitsPerMetre = 100;
constexpr double kMargin_m = 0.7;
constexpr int kFewestPoints = 4;       // minimum per occupied cell
constexpr double kTakenFrom_m = 0.12;  // above the floor
constexpr double kTakenTo_m = 2.0;

std::vector<Eigen::Vector2i> taken_cells(std::span<const StaticSensor> room) {
  std::map<std::pair<int, int>, int> counts;
  for (const StaticSensor& sensor : room) {
    DepthPoints points(sensor.depth);
    points.set(sensor.depth_mm);
    for (int y = 0; y < sensor.depth.height; ++y) {
      for (int x = 0; x < sensor.depth.width; ++x) {
        if (!points.has(x, y)) continue;
        const Eigen::Vector3d p = sensor.world_from_depth * points.point_m(x, y).cast<double>();
        if (p.y() < kTakenFrom_m || p.y() > kTakenTo_m) continue;
        ++counts[{static_cast<int>(std::floor(p.x() / kPlanCell_m)),
                  static_cast<int>(std::floor(p.z() / kPlanCell_m))}];
      }
    }
  }
  std::vector<Eigen::Vector2i> cells;
  for (const auto& [cell, count] : counts) {
    if (count >= kFewestPoints) cells.emplace_back(cell.first, cell.second);
  }
  return cells;
}

template <class... Values>
std::string text(const char* format, Values... values) {
  char buffer[256];
  std::snprintf(buffer, sizeof(buffer), format, values...);
  return buffer;
}

std::string escaped(const std::string& raw) {
  std::string out;
  for (const char c : raw) {
    if (c == '<')
      out += "&lt;";
    else if (c == '&')
      out += "&amp;";
    else
      out += c;
  }
  return out;
}

double units(double metres) {
  return kUnitsPerMetre * metres;
}

Eigen::AlignedBox2d extent_of(const FloorPlan& plan) {
  Eigen::AlignedBox2d box;
  for (const Wall& wall : plan.walls) box.extend(wall.from_m).extend(wall.to_m);
  for (const StaticSensor& sensor : plan.sensors) {
    const Eigen::Vector3d& place = sensor.world_from_depth.translation_m;
    box.extend(Eigen::Vector2d(place.x(), place.z()));
  }
  return box;
}

bool is_inside(const Eigen::AlignedBox2d& box, const Eigen::Vector2i& cell) {
  return box.contains(Eigen::Vector2d(kPlanCell_m * cell.x(), kPlanCell_m * cell.y()));
}

std::string taken_svg(const FloorPlan& plan, const Eigen::AlignedBox2d& box) {
  std::string path = "<path fill=\"#c9d3dd\" d=\"";
  const double side = units(kPlanCell_m);
  for (const auto& cell : plan.taken_cells) {
    if (!is_inside(box, cell)) continue;
    path += text("M%.0f %.0fh%.0fv%.0fh-%.0fz", side * cell.x(), side * cell.y(), side, side, side);
  }
  return path + "\"/>\n";
}

/// A line with its length written next to it, on the side of the room.
std::string wall_svg(const Wall& wall) {
  const Eigen::Vector2d middle = (wall.from_m + wall.to_m) / 2 + 0.22 * wall.normal;
  const Eigen::Vector2d along = wall.to_m - wall.from_m;
  double angle = std::atan2(along.y(), along.x()) * 180 / 3.14159265358979323846;
  if (angle > 90 || angle <= -90) angle += angle > 0 ? -180 : 180;  // keeps the text upright
  return text("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\"/>\n", units(wall.from_m.x()),
              units(wall.from_m.y()), units(wall.to_m.x()), units(wall.to_m.y())) +
         text("<text x=\"%.1f\" y=\"%.1f\" transform=\"rotate(%.1f %.1f %.1f)\">%.2f m</text>\n",
              units(middle.x()), units(middle.y()) + 5, angle, units(middle.x()), units(middle.y()),
              wall.length_m());
}

std::string sensor_svg(const StaticSensor& sensor) {
  const Eigen::Vector3d& place = sensor.world_from_depth.translation_m;
  const Eigen::Vector3d ahead = sensor.world_from_depth.rotation.col(2);
  const Eigen::Vector2d at(place.x(), place.z());
  const Eigen::Vector2d forward = Eigen::Vector2d(ahead.x(), ahead.z()).normalized();
  const Eigen::Vector2d side(-forward.y(), forward.x());
  const Eigen::Vector2d left = at + 0.3 * forward + 0.16 * side;
  const Eigen::Vector2d right = at + 0.3 * forward - 0.16 * side;
  return text("<path class=\"sensor\" d=\"M%.1f %.1fL%.1f %.1fL%.1f %.1fz\"/>\n", units(at.x()),
              units(at.y()), units(left.x()), units(left.y()), units(right.x()), units(right.y())) +
         text("<text class=\"name\" x=\"%.1f\" y=\"%.1f\">", units(at.x() + 0.5 * forward.x()),
              units(at.y() + 0.5 * forward.y()) + 5) +
         escaped(sensor.name) + "</text>\n";
}

std::string scale_svg(const Eigen::AlignedBox2d& view) {
  const double x = units(view.min().x()) + 25, y = units(view.max().y()) - 22;
  return text("<path class=\"scale\" d=\"M%.1f %.1fv10h100v-10\"/>\n", x, y - 10) +
         text("<text x=\"%.1f\" y=\"%.1f\">1 m</text>\n", x + 50, y - 8);
}

constexpr const char* kStyle =
    "<style>"
    "text{font:16px sans-serif;text-anchor:middle;fill:#333}"
    ".title{font-size:20px;font-weight:bold;text-anchor:start}"
    ".name{fill:#b3400f}"
    "line{stroke:#222;stroke-width:7;stroke-linecap:round}"
    ".sensor{fill:#f0824c}"
    ".scale{fill:none;stroke:#333;stroke-width:2}"
    "</style>\n";

}  // namespace

Result<FloorPlan> draw_floor_plan(std::span<const StaticSensor> room) {
  FloorPlan plan;
  plan.walls = find_walls(upright_points(room));
  if (plan.walls.empty()) {
    return Error{ErrorCode::kNotFound,
                 "no wall was found in this recording; a floor plan needs one"};
  }
  plan.taken_cells = taken_cells(room);
  for (const StaticSensor& sensor : room) {
    plan.sensors.push_back(sensor);
    plan.sensors.back().depth_mm = {};
  }
  return plan;
}

std::string floor_plan_svg(const FloorPlan& plan, const std::string& title) {
  const Eigen::AlignedBox2d box = extent_of(plan);
  Eigen::AlignedBox2d view = box;
  view.min().array() -= kMargin_m;
  view.max().array() += kMargin_m;
  Eigen::AlignedBox2d drawn = box;
  drawn.min().array() -= 0.1;
  drawn.max().array() += 0.1;
  const Eigen::Vector2d size = view.sizes();
  std::string svg =
      text("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" ",
           units(size.x()), units(size.y())) +
      text("viewBox=\"%.1f %.1f %.1f %.1f\">\n", units(view.min().x()), units(view.min().y()),
           units(size.x()), units(size.y())) +
      kStyle +
      text("<rect x=\"%.1f\" y=\"%.1f\" width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n",
           units(view.min().x()), units(view.min().y())) +
      taken_svg(plan, drawn);
  for (const Wall& wall : plan.walls) svg += wall_svg(wall);
  for (const StaticSensor& sensor : plan.sensors) svg += sensor_svg(sensor);
  svg += scale_svg(view);
  svg += text("<text class=\"title\" x=\"%.1f\" y=\"%.1f\">", units(view.min().x()) + 20,
              units(view.min().y()) + 34) +
         escaped(title) + "</text>\n";
  return svg + "</svg>\n";
}

}  // namespace roomcast::recording
