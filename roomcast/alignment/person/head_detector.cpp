// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/person/head_detector.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "roomcast/alignment/rig/world_frame.h"
#include "roomcast/alignment/view/depth_noise.h"
#include "roomcast/alignment/view/depth_surface.h"
#include "roomcast/alignment/view/floor.h"

namespace roomcast::alignment {
namespace {

constexpr int kPixelStep = 2;
constexpr float kBefore_m = 0.08F, kBeforeSigmas = 4;  // nearer than the background by more
constexpr float kMinHeight_m = 0.4F;                   // lower blobs are furniture that was moved
constexpr float kCell_m = 0.08F, kReach_m = 8;         // of the plan, to each side of the sensor
constexpr int kCells = static_cast<int>(2 * kReach_m / kCell_m);
constexpr float kCellArea_m2 = 0.002F;   // visible surface in a cell that counts
constexpr float kPersonArea_m2 = 0.12F;  // visible surface of a person, at least
constexpr float kHeadLength_m = 0.20F;   // below the top
constexpr float kCrown_m = 0.05F;        // below the top: where heads differ least
constexpr float kHeadRadius_m = 0.16F;   // about its middle
constexpr float kTopShare = 0.01F;       // of the points, allowed above the top: flying pixels

bool is_at_border(DepthView picture, int x, int y) {
  constexpr int kBorder = 8;  // depth cameras have few readings there
  return x < kBorder || y < kBorder || x >= picture.width - kBorder;
}

/// The surface points of one person, in the level frame.
struct Body {
  std::vector<Eigen::Vector3f> points_m;
  std::vector<float> areas_m2;
  float area_m2 = 0;
  float highest_cut_m = 0;  // of the points at the picture's border
};

float top_of(const Body& body) {
  std::vector<float> heights;
  heights.reserve(body.points_m.size());
  for (const auto& point : body.points_m) heights.push_back(point.y());
  const auto at = heights.begin() + static_cast<std::ptrdiff_t>(
                                        (1 - kTopShare) * static_cast<float>(heights.size() - 1));
  std::nth_element(heights.begin(), at, heights.end());
  return *at;
}

/// The mean of the points between these heights and near `about` in plan.
std::optional<Eigen::Vector3f> middle_of(const Body& body, float low_m, float high_m,
                                         const Eigen::Vector3f* about) {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  float weight = 0;
  for (std::size_t i = 0; i < body.points_m.size(); ++i) {
    const Eigen::Vector3f& point = body.points_m[i];
    if (point.y() < low_m || point.y() > high_m) continue;
    if (about != nullptr) {
      const Eigen::Vector3f apart = point - *about;
      if (std::hypot(apart.x(), apart.z()) > kHeadRadius_m) continue;
    }
    sum += body.areas_m2[i] * point;
    weight += body.areas_m2[i];
  }
  if (!(weight > 0)) return std::nullopt;
  return sum / weight;
}

std::optional<Eigen::Vector3f> head_of(const Body& body) {
  const float top_m = top_of(body);
  if (top_m < kMinHead_m || top_m > kMaxHead_m) return std::nullopt;
  if (body.highest_cut_m > top_m - kHeadLength_m) return std::nullopt;  // cut off at the border
  const float chin_m = top_m - kHeadLength_m, above_m = top_m + 0.03F;
  auto head = middle_of(body, top_m - 0.5F * kHeadLength_m, above_m, nullptr);
  for (int step = 0; head && step < 3; ++step) head = middle_of(body, chin_m, above_m, &*head);
  return head ? middle_of(body, top_m - kCrown_m, above_m, &*head) : std::nullopt;
}

}  // namespace

std::optional<Plane> floor_of(const CalibrationBundle& bundle) {
  const auto surface = depth_surface(bundle.depth_mm, bundle.calibration.depth);
  return find_floor(find_planes(surface.samples), surface.samples, bundle.up);
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
  const Eigen::Matrix3f rotation = level_from_depth.rotation.cast<float>();
  const Eigen::Vector3f shift = level_from_depth.translation_m.cast<float>();
  for (int y = 0; y < depth_mm.height; y += kPixelStep) {
    for (int x = 0; x < depth_mm.width; x += kPixelStep) {
      const float room_m = 0.001F * static_cast<float>(room_mm.at(x, y));
      const float z_m = 0.001F * static_cast<float>(depth_mm.at(x, y));
      if (!(z_m > kNearestSurface_m && room_m > 0)) continue;
      if (room_m - z_m < kBefore_m + kBeforeSigmas * depth_sigma_m(room_m)) continue;
      const Eigen::Vector3f level = rotation * (z_m * rays.at(x, y).homogeneous()) + shift;
      if (!(level.y() > kMinHeight_m && level.y() < kMaxHead_m + kCell_m)) continue;
      const int column = static_cast<int>((level.x() + kReach_m) / kCell_m);
      const int row = static_cast<int>((level.z() + kReach_m) / kCell_m);
      if (column < 1 || row < 1 || column >= kCells - 1 || row >= kCells - 1) continue;
      readings.push_back(
          {level, area_per_z2 * z_m * z_m, row * kCells + column, is_at_border(depth_mm, x, y)});
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
    if (bodies[cell] < 0 && areas_m2[cell] >= kCellArea_m2) spread(reading.cell, count++);
  }
  return count;
}

void HeadDetector::Plan::spread(int from, int body) {
  unvisited.assign(1, from);
  bodies[static_cast<std::size_t>(from)] = body;
  while (!unvisited.empty()) {
    const int cell = unvisited.back();
    unvisited.pop_back();
    for (const int step :
         {-kCells - 1, -kCells, -kCells + 1, -1, 1, kCells - 1, kCells, kCells + 1}) {
      const auto next = static_cast<std::size_t>(cell + step);
      const int row = (cell + step) / kCells, column = (cell + step) % kCells;
      if (row < 1 || column < 1 || row >= kCells - 1 || column >= kCells - 1) continue;
      if (bodies[next] >= 0 || areas_m2[next] < kCellArea_m2) continue;
      bodies[next] = body;
      unvisited.push_back(cell + step);
    }
  }
}

HeadDetector::HeadDetector(const CalibrationBundle& bundle, const Plane& floor)
    : plan_(std::make_unique<Plan>()) {
  const CameraIntrinsics& camera = bundle.calibration.depth;
  plan_->room_mm = bundle.depth_mm;
  plan_->rays = ray_table(camera);
  plan_->level_from_depth = alignment::level_from_depth(floor);
  plan_->area_per_z2 = static_cast<float>(kPixelStep * kPixelStep / (camera.fx * camera.fy));
  plan_->areas_m2.resize(std::size_t{kCells} * kCells);
  plan_->bodies.resize(std::size_t{kCells} * kCells);
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
  std::erase_if(bodies, [](const Body& body) { return body.area_m2 < kPersonArea_m2; });
  std::ranges::stable_sort(bodies, std::greater(), &Body::area_m2);
  const RigidTransform depth_from_level = plan_->level_from_depth.inverse();
  std::vector<Eigen::Vector3f> heads;
  for (const Body& body : bodies) {
    const auto head = head_of(body);
    if (head && heads.size() < kMaxHeads)
      heads.emplace_back((depth_from_level * head->cast<double>()).cast<float>());
  }
  return heads;
}

}  // namespace roomcast::alignment
