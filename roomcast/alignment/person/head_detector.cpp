// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/person/head_detector.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "roomcast/alignment/rig/world_frame.h"

namespace roomcast::alignment {
namespace {

bool is_at_border(DepthView picture, int border, int x, int y) {
  return x < border || y < border || x >= picture.width - border;
}

/// The surface points of one person, in the level frame.
struct Body {
  std::vector<Eigen::Vector3f> points_m;
  std::vector<float> areas_m2;
  float area_m2 = 0;
  float highest_cut_m = 0;  // of the points at the picture's border
};

float top_of(const Body& body, float above_share) {
  std::vector<float> heights;
  heights.reserve(body.points_m.size());
  for (const auto& point : body.points_m) heights.push_back(point.y());
  const auto at = heights.begin() + static_cast<std::ptrdiff_t>(
                                        (1 - above_share) * static_cast<float>(heights.size() - 1));
  std::nth_element(heights.begin(), at, heights.end());
  return *at;
}

/// The mean of the points between these heights and near `about` in plan.
std::optional<Eigen::Vector3f> middle_of(const Body& body, float low_m, float high_m,
                                         float radius_m, const Eigen::Vector3f* about) {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  float weight = 0;
  for (std::size_t i = 0; i < body.points_m.size(); ++i) {
    const Eigen::Vector3f& point = body.points_m[i];
    if (point.y() < low_m || point.y() > high_m) continue;
    if (about != nullptr) {
      const Eigen::Vector3f apart = point - *about;
      if (std::hypot(apart.x(), apart.z()) > radius_m) continue;
    }
    sum += body.areas_m2[i] * point;
    weight += body.areas_m2[i];
  }
  if (!(weight > 0)) return std::nullopt;
  return sum / weight;
}

std::optional<Eigen::Vector3f> head_of(const Body& body, const HeadDetectorOptions& options) {
  const float top_m = top_of(body, options.above_share);
  if (top_m < options.min_head_m || top_m > options.max_head_m) return std::nullopt;
  const float length_m = options.head_length_m, radius_m = options.head_radius_m;
  if (body.highest_cut_m > top_m - length_m) return std::nullopt;  // cut off at the border
  const float chin_m = top_m - length_m, above_m = top_m + options.above_top_m;
  auto head = middle_of(body, top_m - 0.5F * length_m, above_m, radius_m, nullptr);
  for (int step = 0; head && step < 3; ++step)
    head = middle_of(body, chin_m, above_m, radius_m, &*head);
  return head ? middle_of(body, top_m - options.crown_m, above_m, radius_m, &*head) : std::nullopt;
}

}  // namespace

std::optional<Plane> floor_of(const CalibrationBundle& bundle,
                              const DepthSurfaceOptions& surface_options,
                              const PlaneOptions& planes, const FloorOptions& floor) {
  const auto surface = depth_surface(bundle.depth_mm, bundle.calibration.depth, surface_options);
  return find_floor(find_planes(surface.samples, planes), surface.samples, bundle.up, floor);
}

RigidTransform level_from_depth(const Plane& floor) {
  return world_frame(std::array{floor}).world_from_origin;
}

/// The plan view and its blobs.
struct HeadDetector::Plan {
  struct Reading {
    Eigen::Vector3f level_m;
    float area_m2;
    int cell;
    bool at_border;
  };

  HeadDetectorOptions options;
  int cells = 0;  // of the plan, along each side
  DepthImage room_mm;
  Image<Eigen::Vector2f> rays;
  RigidTransform level_from_depth;
  float area_per_z2 = 0;  // of the surface behind a sampled pixel
  std::vector<Reading> readings;
  std::vector<float> areas_m2;  // by cell
  std::vector<int> bodies;      // by cell: which body, or -1
  std::vector<int> unvisited;   // a stack

  void take_readings(DepthView depth_mm);
  [[nodiscard]] int label_bodies();
  void spread(int from, int body);
};

void HeadDetector::Plan::take_readings(DepthView depth_mm) {
  readings.clear();
  const HeadDetectorOptions limits = options;  // the loop writes memory that could be theirs
  const Eigen::Matrix3f rotation = level_from_depth.rotation.cast<float>();
  const Eigen::Vector3f shift = level_from_depth.translation_m.cast<float>();
  for (int y = 0; y < depth_mm.height; y += limits.pixel_step) {
    for (int x = 0; x < depth_mm.width; x += limits.pixel_step) {
      const float room_m = 0.001F * static_cast<float>(room_mm.at(x, y));
      const float z_m = 0.001F * static_cast<float>(depth_mm.at(x, y));
      if (!(z_m > limits.nearest_m && room_m > 0)) continue;
      if (room_m - z_m < limits.before_m + limits.before_sigmas * limits.noise.sigma_m(room_m))
        continue;
      const Eigen::Vector3f level = rotation * (z_m * rays.at(x, y).homogeneous()) + shift;
      if (!(level.y() > limits.min_height_m && level.y() < limits.max_head_m + limits.cell_m))
        continue;
      const int column = static_cast<int>((level.x() + limits.reach_m) / limits.cell_m);
      const int row = static_cast<int>((level.z() + limits.reach_m) / limits.cell_m);
      if (column < 1 || row < 1 || column >= cells - 1 || row >= cells - 1) continue;
      readings.push_back({level, area_per_z2 * z_m * z_m, row * cells + column,
                          is_at_border(depth_mm, limits.border_px, x, y)});
    }
  }
}

/// Labels connected cells as one body. Returns the number of bodies.
int HeadDetector::Plan::label_bodies() {
  std::ranges::fill(areas_m2, 0.F);
  std::ranges::fill(bodies, -1);
  for (const Reading& reading : readings)
    areas_m2[static_cast<std::size_t>(reading.cell)] += reading.area_m2;
  int count = 0;
  for (const Reading& reading : readings) {
    const auto cell = static_cast<std::size_t>(reading.cell);
    if (bodies[cell] < 0 && areas_m2[cell] >= options.cell_area_m2) spread(reading.cell, count++);
  }
  return count;
}

void HeadDetector::Plan::spread(int from, int body) {
  unvisited.assign(1, from);
  bodies[static_cast<std::size_t>(from)] = body;
  while (!unvisited.empty()) {
    const int cell = unvisited.back();
    unvisited.pop_back();
    for (const int step : {-cells - 1, -cells, -cells + 1, -1, 1, cells - 1, cells, cells + 1}) {
      const auto next = static_cast<std::size_t>(cell + step);
      const int row = (cell + step) / cells, column = (cell + step) % cells;
      if (row < 1 || column < 1 || row >= cells - 1 || column >= cells - 1) continue;
      if (bodies[next] >= 0 || areas_m2[next] < options.cell_area_m2) continue;
      bodies[next] = body;
      unvisited.push_back(cell + step);
    }
  }
}

HeadDetector::HeadDetector(const CalibrationBundle& bundle, const Plane& floor,
                           const HeadDetectorOptions& options)
    : plan_(std::make_unique<Plan>()) {
  const CameraIntrinsics& camera = bundle.calibration.depth;
  plan_->options = options;
  plan_->cells = options.cells();
  plan_->room_mm = bundle.depth_mm;
  plan_->rays = ray_table(camera);
  plan_->level_from_depth = alignment::level_from_depth(floor);
  plan_->area_per_z2 =
      static_cast<float>(options.pixel_step * options.pixel_step / (camera.fx * camera.fy));
  const std::size_t cells =
      static_cast<std::size_t>(plan_->cells) * static_cast<std::size_t>(plan_->cells);
  plan_->areas_m2.resize(cells);
  plan_->bodies.resize(cells);
}
HeadDetector::~HeadDetector() = default;
HeadDetector::HeadDetector(HeadDetector&&) noexcept = default;
HeadDetector& HeadDetector::operator=(HeadDetector&&) noexcept = default;

std::vector<Eigen::Vector3f> HeadDetector::find(DepthView depth_mm) {
  plan_->take_readings(depth_mm);
  std::vector<Body> bodies(static_cast<std::size_t>(plan_->label_bodies()));
  for (const Plan::Reading& reading : plan_->readings) {
    const int of = plan_->bodies[static_cast<std::size_t>(reading.cell)];
    if (of < 0) continue;
    Body& body = bodies[static_cast<std::size_t>(of)];
    body.points_m.push_back(reading.level_m);
    body.areas_m2.push_back(reading.area_m2);
    body.area_m2 += reading.area_m2;
    if (reading.at_border) body.highest_cut_m = std::max(body.highest_cut_m, reading.level_m.y());
  }
  std::erase_if(bodies, [least_m2 = plan_->options.person_area_m2](const Body& body) {
    return body.area_m2 < least_m2;
  });
  std::ranges::stable_sort(bodies, std::greater(), &Body::area_m2);
  const RigidTransform depth_from_level = plan_->level_from_depth.inverse();
  std::vector<Eigen::Vector3f> heads;
  for (const Body& body : bodies) {
    const auto head = head_of(body, plan_->options);
    if (head && heads.size() < plan_->options.max_heads)
      heads.emplace_back((depth_from_level * head->cast<double>()).cast<float>());
  }
  return heads;
}

}  // namespace roomcast::alignment
