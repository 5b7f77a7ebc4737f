// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/measure/wall_finder.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <unordered_set>

#include <Eigen/Eigenvalues>

#include "roomcast/recording/export/depth_points.h"

namespace roomcast::recording {
namespace {

constexpr double kMaxTilt = 0.2;   // of an upright surface's normal: some 12 degrees
constexpr double kNear_m = 0.05;   // distance from a line: noise and bias of readings
constexpr double kSameWay = 0.94;  // cosine of 20 degrees
constexpr double kCell_m = 0.1;    // grid on a wall by which area is counted
constexpr double kSmallestWall_m2 = 0.6;
constexpr double kShortestWall_m = 0.4;
constexpr double kTallEnough_m = 1.2;  // above the floor; lower surfaces are furniture
constexpr double kBehind_m = 0.15;
constexpr double kMaxBehind = 0.12;      // maximum share of a wall's length with surface behind
constexpr double kNearlySquare = 0.985;  // cosine of 10 degrees
constexpr double kSquareShare = 0.8;     // of its area, for a line that is made perpendicular
constexpr double kBefore_m = 0.6;        // depth of objects in front of a wall
constexpr double kCornerGap_m = 0.6;
constexpr int kTriedLines = 400;  // per wall
constexpr std::size_t kMaxWalls = 24;

/// normal . p == offset_m
struct Line {
  Eigen::Vector2d normal;
  double offset_m = 0;

  [[nodiscard]] double distance_m(const Eigen::Vector2d& p) const {
    return normal.dot(p) - offset_m;
  }
  [[nodiscard]] double along_m(const Eigen::Vector2d& p) const {
    return normal.x() * p.y() - normal.y() * p.x();
  }
  [[nodiscard]] Eigen::Vector2d at(double along_m) const {
    return normal * offset_m + Eigen::Vector2d(-normal.y(), normal.x()) * along_m;
  }
};

bool lies_on(const Line& line, const UprightPoint& point) {
  return std::abs(line.distance_m(point.plan_m)) < kNear_m &&
         line.normal.dot(point.normal) > kSameWay;
}

std::int64_t cell_of(double value_m) {
  return static_cast<std::int64_t>(std::floor(value_m / kCell_m));
}
std::int64_t cell_of(const Line& line, const UprightPoint& point) {
  return cell_of(line.along_m(point.plan_m)) * 1024 + cell_of(point.height_m);
}

using Cells = std::unordered_set<std::int64_t>;
using Points = std::vector<UprightPoint>;

double area_m2(const Line& line, const Points& points) {
  Cells cells;
  for (const auto& point : points) {
    if (lies_on(line, point)) cells.insert(cell_of(line, point));
  }
  return kCell_m * kCell_m * static_cast<double>(cells.size());
}

/// Every n-th point, to speed up the many tried lines.
Points thinned(const Points& points, std::size_t count) {
  const std::size_t step = std::max<std::size_t>(1, points.size() / count);
  Points few;
  for (std::size_t i = 0; i < points.size(); i += step) few.push_back(points[i]);
  return few;
}

std::optional<Line> largest_line(const Points& points) {
  constexpr std::size_t kTriedPoints = 6000;
  const Points few = thinned(points, kTriedPoints);
  const std::size_t step = std::max<std::size_t>(1, few.size() / kTriedLines);
  std::optional<Line> best;
  double most_m2 = 0;
  for (std::size_t i = 0; i < few.size(); i += step) {
    const Line line{few[i].normal, few[i].normal.dot(few[i].plan_m)};
    const double area = area_m2(line, few);
    if (area <= most_m2) continue;
    most_m2 = area;
    best = line;
  }
  return best;
}

/// Weighted total least squares over the points on the line; Tukey's weights (Beaton & Tukey 1974)
/// limit the influence of objects just in front of the wall.
Line fitted(Line line, const Points& points) {
  for (int round = 0; round < 8; ++round) {
    const double width_m = round < 3 ? kNear_m : 0.6 * kNear_m;
    double sum = 0;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
    for (const auto& point : points) {
      if (!lies_on(line, point)) continue;
      const double share = line.distance_m(point.plan_m) / width_m;
      if (std::abs(share) >= 1) continue;
      const double weight = point.weight * (1 - share * share) * (1 - share * share);
      sum += weight;
      mean += weight * point.plan_m;
      scatter += weight * point.plan_m * point.plan_m.transpose();
    }
    if (sum <= 0) return line;
    mean /= sum;
    scatter = scatter / sum - mean * mean.transpose();
    Eigen::Vector2d normal =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(scatter).eigenvectors().col(0);
    if (normal.dot(line.normal) < 0) normal = -normal;
    line = {normal, normal.dot(mean)};
  }
  return line;
}

/// Refits by least squares with the direction fixed.
Line fitted_along(const Eigen::Vector2d& normal, const Line& line, const Points& points) {
  double sum = 0, offsets = 0;
  for (const auto& point : points) {
    if (!lies_on(line, point)) continue;
    sum += point.weight;
    offsets += point.weight * normal.dot(point.plan_m);
  }
  Line square{normal, sum > 0 ? offsets / sum : line.offset_m};
  for (int round = 0; round < 8; ++round) {
    double weights = 0, moved = 0;
    for (const auto& point : points) {
      if (!lies_on(square, point)) continue;
      const double share = square.distance_m(point.plan_m) / kNear_m;
      const double weight = point.weight * (1 - share * share) * (1 - share * share);
      weights += weight;
      moved += weight * square.distance_m(point.plan_m);
    }
    if (weights <= 0) break;
    square.offset_m += moved / weights;
  }
  return square;
}

/// Makes a line perpendicular or parallel to the largest wall if it nearly is and the change keeps
/// most of its covered area. Most walls are at right angles; this prevents a line from joining a
/// wall with objects in front of it.
Line squared(const Line& line, const Eigen::Vector2d& main_normal, const Points& points) {
  const Eigen::Vector2d aside(-main_normal.y(), main_normal.x());
  for (const Eigen::Vector2d& normal :
       {main_normal, aside, Eigen::Vector2d(-main_normal), Eigen::Vector2d(-aside)}) {
    if (normal.dot(line.normal) < kNearlySquare) continue;
    const Line square = fitted_along(normal, line, points);
    if (area_m2(square, points) > kSquareShare * area_m2(line, points)) return square;
  }
  return line;
}

/// True if `front` is a flat object in front of a wall: a larger parallel wall is close behind it.
bool stands_before(const Wall& front, const Wall& wall) {
  if (front.area_m2 >= wall.area_m2) return false;
  if (front.normal.dot(wall.normal) < kSameWay) return false;
  const Eigen::Vector2d middle = (front.from_m + front.to_m) / 2;
  const double before_m = wall.normal.dot(middle) - wall.offset_m();
  if (before_m < -kNear_m || before_m > kBefore_m) return false;
  const Eigen::Vector2d along = (wall.to_m - wall.from_m).normalized();
  const double place_m = along.dot(middle - wall.from_m);
  return place_m > 0 && place_m < wall.length_m();
}

/// The wall on a line: the segment between its outermost points, with outliers trimmed; nothing if
/// the area is too small, the top too low or the segment too short.
std::optional<Wall> wall_on(const Line& line, const Points& points) {
  std::vector<double> along_m;
  Cells cells;
  double top_m = 0;
  for (const auto& point : points) {
    if (!lies_on(line, point)) continue;
    along_m.push_back(line.along_m(point.plan_m));
    cells.insert(cell_of(line, point));
    top_m = std::max(top_m, point.height_m);
  }
  const double seen_m2 = kCell_m * kCell_m * static_cast<double>(cells.size());
  if (seen_m2 < kSmallestWall_m2 || top_m < kTallEnough_m) return std::nullopt;
  std::ranges::sort(along_m);
  const std::size_t cut = along_m.size() / 200;  // trims outliers at the ends
  const Wall wall{line.at(along_m[cut]), line.at(along_m[along_m.size() - 1 - cut]), line.normal,
                  seen_m2};
  if (wall.length_m() < kShortestWall_m) return std::nullopt;
  return wall;
}

/// True if surface was seen behind the wall over a large part of its length.
bool has_things_behind(const Wall& wall, const Line& line, std::span<const UprightPoint> all) {
  const double begin_m = line.along_m(wall.from_m), end_m = line.along_m(wall.to_m);
  Cells columns;
  for (const auto& point : all) {
    const double along_m = line.along_m(point.plan_m);
    if (along_m < begin_m || along_m > end_m) continue;
    if (line.distance_m(point.plan_m) < -kBehind_m) columns.insert(cell_of(along_m));
  }
  const double share = kCell_m * static_cast<double>(columns.size()) / wall.length_m();
  return share > kMaxBehind;
}

std::optional<Eigen::Vector2d> corner_of(const Wall& a, const Wall& b) {
  Eigen::Matrix2d normals;
  normals << a.normal.transpose(), b.normal.transpose();
  if (std::abs(normals.determinant()) < 0.5) return std::nullopt;
  return normals.inverse() * Eigen::Vector2d(a.offset_m(), b.offset_m());
}

/// Extends or trims the wall's end near `corner` to the corner.
void lead_to(const Eigen::Vector2d& corner, Wall& wall) {
  Eigen::Vector2d& end =
      (wall.from_m - corner).norm() < (wall.to_m - corner).norm() ? wall.from_m : wall.to_m;
  if ((end - corner).norm() < kCornerGap_m) end = corner;
}

void join_corners(std::vector<Wall>& walls) {
  for (std::size_t i = 0; i < walls.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto corner = corner_of(walls[i], walls[j]);
      const auto is_near = [&](const Wall& wall) {
        return std::min((wall.from_m - *corner).norm(), (wall.to_m - *corner).norm()) <
               kCornerGap_m;
      };
      if (!corner || !is_near(walls[i]) || !is_near(walls[j])) continue;
      lead_to(*corner, walls[i]);
      lead_to(*corner, walls[j]);
    }
  }
}

void add_points(const StaticSensor& sensor, std::vector<UprightPoint>& out) {
  DepthPoints points(sensor.depth);
  points.set(sensor.depth_mm);
  const Eigen::Matrix3d& rotation = sensor.world_from_depth.rotation;
  for (int y = 0; y < sensor.depth.height; ++y) {
    for (int x = 0; x < sensor.depth.width; ++x) {
      if (!points.has(x, y)) continue;
      const Eigen::Vector3d normal = rotation * points.normal(x, y).cast<double>();
      const Eigen::Vector3d world_m = sensor.world_from_depth * points.point_m(x, y).cast<double>();
      if (std::abs(normal.y()) > kMaxTilt || world_m.y() < kLowest_m || world_m.y() > kHighest_m)
        continue;
      const double sigma_m = reading_sigma_m(points.z_m(x, y));
      out.push_back({{world_m.x(), world_m.z()},
                     Eigen::Vector2d(normal.x(), normal.z()).normalized(),
                     world_m.y(),
                     1 / (sigma_m * sigma_m)});
    }
  }
}

}  // namespace

std::vector<UprightPoint> upright_points(std::span<const StaticSensor> room) {
  std::vector<UprightPoint> points;
  for (const StaticSensor& sensor : room) add_points(sensor, points);
  return points;
}

std::vector<Wall> find_walls(std::span<const UprightPoint> all) {
  Points points(all.begin(), all.end());
  std::vector<Wall> walls;
  for (std::size_t tries = 0; tries < kMaxWalls && !points.empty(); ++tries) {
    const auto found = largest_line(points);
    if (!found) break;
    Line line = fitted(*found, points);
    if (!walls.empty()) line = squared(line, walls.front().normal, points);
    const auto wall = wall_on(line, points);
    if (wall && !has_things_behind(*wall, line, all)) walls.push_back(*wall);
    const std::size_t before = points.size();
    std::erase_if(points, [&](const UprightPoint& point) { return lies_on(line, point); });
    if (points.size() == before) break;
  }
  const auto copy = walls;
  std::erase_if(walls, [&](const Wall& front) {
    return std::ranges::any_of(copy, [&](const Wall& wall) { return stands_before(front, wall); });
  });
  join_corners(walls);
  std::ranges::sort(walls, std::greater<>(), &Wall::area_m2);
  return walls;
}

}  // namespace roomcast::recording
