// SPDX-License-Identifier: Apache-2.0
#include "roomcast/align/board/tag_finder.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>

namespace roomcast::align {
namespace {

constexpr float kDecimate =
    1.5F;  // pictures are searched this much smaller, corners refined in full
constexpr int kBitsCorrected = 1;    // more would take other things for tags
constexpr double kLeastMargin = 30;  // of a detection's contrast
constexpr std::size_t kLeastReadings = 25;
constexpr double kLeastIncidence = 0.35;  // cosine
constexpr double kSidesAlike = 0.15;      // of a square that is one

using Pixels = std::array<Eigen::Vector2d, 4>;

struct DepthPlane {
  Eigen::Vector3d normal, at_m;
};

bool is_inside(const Pixels& quad, const Eigen::Vector2d& pixel) {
  int left = 0;
  for (std::size_t i = 0; i < quad.size(); ++i) {
    const Eigen::Vector2d side = quad[(i + 1) % 4] - quad[i], to = pixel - quad[i];
    left += side.x() * to.y() - side.y() * to.x() > 0;
  }
  return left == 0 || left == 4;
}

DepthPlane plane_through(const std::vector<Eigen::Vector3d>& points_m) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& point : points_m) mean += point / static_cast<double>(points_m.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const auto& point : points_m) spread += (point - mean) * (point - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  return {axes.eigenvectors().col(0), mean};
}

/// Without the points that lie furthest from it: flying pixels, fingers.
std::optional<DepthPlane> steady_plane(std::vector<Eigen::Vector3d> points_m) {
  constexpr int kRounds = 3;
  constexpr double kKept = 0.85;
  for (int round = 0; round < kRounds; ++round) {
    if (points_m.size() < kLeastReadings) return std::nullopt;
    const DepthPlane plane = plane_through(points_m);
    const auto off = [&](const Eigen::Vector3d& p) {
      return std::abs(plane.normal.dot(p - plane.at_m));
    };
    const auto kept = static_cast<std::ptrdiff_t>(kKept * static_cast<double>(points_m.size()));
    std::nth_element(points_m.begin(), points_m.begin() + kept, points_m.end(),
                     [&](const auto& a, const auto& b) { return off(a) < off(b); });
    points_m.resize(static_cast<std::size_t>(kept));
  }
  const DepthPlane plane = plane_through(points_m);
  if (std::abs(plane.normal.dot(plane.at_m.normalized())) < kLeastIncidence) return std::nullopt;
  return plane;
}

bool is_square(const std::array<Eigen::Vector3d, 4>& corners_m) {
  double shortest = 1e9, longest = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double side = (corners_m[(i + 1) % 4] - corners_m[i]).norm();
    shortest = std::min(shortest, side);
    longest = std::max(longest, side);
  }
  return shortest > (1 - kSidesAlike) * longest;
}

}  // namespace

struct TagFinder::Detector {
  SensorCalibration calibration;
  Image<Eigen::Vector2f> rays;  // of the depth camera
  apriltag_family_t* family = tag36h11_create();
  apriltag_detector_t* detector = apriltag_detector_create();
  Image<std::uint8_t> grey;

  explicit Detector(const SensorCalibration& cameras)
      : calibration(cameras), rays(ray_table(cameras.depth)) {
    apriltag_detector_add_family_bits(detector, family, kBitsCorrected);
    detector->quad_decimate = kDecimate;
    detector->nthreads = 1;
  }
  ~Detector() {
    apriltag_detector_destroy(detector);
    tag36h11_destroy(family);
  }
  Detector(const Detector&) = delete;
  Detector& operator=(const Detector&) = delete;

  void make_grey(ColorView color) {
    grey.resize(color.width, color.height);
    for (int y = 0; y < color.height; ++y) {
      for (int x = 0; x < color.width; ++x) {
        const auto& p = color.at(x, y);
        grey.at(x, y) = static_cast<std::uint8_t>((77 * p.r + 150 * p.g + 29 * p.b) >> 8);
      }
    }
  }

  /// In the colour camera's frame.
  [[nodiscard]] std::vector<Eigen::Vector3d> readings_on(const Pixels& quad,
                                                         DepthView depth_mm) const {
    std::vector<Eigen::Vector3d> points_m;
    for (int y = 0; y < depth_mm.height; ++y) {
      for (int x = 0; x < depth_mm.width; ++x) {
        const double z_m = 0.001 * depth_mm.at(x, y);
        const Eigen::Vector2f& ray = rays.at(x, y);
        if (!(z_m > 0) || std::isnan(ray.x())) continue;
        const Eigen::Vector3d point =
            calibration.color_from_depth * (z_m * ray.cast<double>().homogeneous());
        const auto pixel = project(calibration.color, point);
        if (pixel && is_inside(quad, *pixel)) points_m.push_back(point);
      }
    }
    return points_m;
  }

  [[nodiscard]] std::optional<SeenTag> lift(const apriltag_detection_t& found,
                                            DepthView depth_mm) const {
    Pixels quad;
    // The library counts from the corner of the first pixel, we from its middle.
    for (std::size_t i = 0; i < 4; ++i)
      quad[i] = Eigen::Vector2d(found.p[i][0], found.p[i][1]).array() - 0.5;
    const auto plane = steady_plane(readings_on(quad, depth_mm));
    if (!plane) return std::nullopt;
    SeenTag tag{found.id, {}};
    const RigidTransform depth_from_color = calibration.color_from_depth.inverse();
    for (std::size_t i = 0; i < 4; ++i) {
      const auto ray = unproject(calibration.color, quad[i], 1);
      if (!ray) return std::nullopt;
      const double z_m = plane->normal.dot(plane->at_m) / plane->normal.dot(*ray);
      tag.corners_m[i] = depth_from_color * (z_m * *ray);
    }
    if (!is_square(tag.corners_m)) return std::nullopt;
    return tag;
  }
};

TagFinder::TagFinder(const SensorCalibration& calibration)
    : detector_(std::make_unique<Detector>(calibration)) {}
TagFinder::~TagFinder() = default;
TagFinder::TagFinder(TagFinder&&) noexcept = default;
TagFinder& TagFinder::operator=(TagFinder&&) noexcept = default;

std::vector<SeenTag> TagFinder::find(DepthView depth_mm, ColorView color) {
  detector_->make_grey(color);
  image_u8_t picture = {color.width, color.height, color.width, detector_->grey.data()};
  zarray_t* const found = apriltag_detector_detect(detector_->detector, &picture);
  std::vector<SeenTag> tags;
  for (int i = 0; i < zarray_size(found); ++i) {
    apriltag_detection_t* detection = nullptr;
    zarray_get(found, i, &detection);
    if (static_cast<double>(detection->decision_margin) < kLeastMargin) continue;
    if (auto tag = detector_->lift(*detection, depth_mm)) tags.push_back(*tag);
  }
  apriltag_detections_destroy(found);
  return tags;
}

}  // namespace roomcast::align
