// SPDX-License-Identifier: Apache-2.0
#include "bench/redundancy/better_shown.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include <Eigen/Geometry>

namespace roomcast::bench {
namespace {

constexpr int kBeside_px = 3;      // between the points from which a normal is computed
constexpr double kSteepest = 0.2;  // relative change of depth over them: else it is an edge
constexpr double kMinCosine = 0.1;

/// In the sensor's frame, metres.
std::optional<Eigen::Vector3d> point_at(const SensorDepth& sensor, int x, int y) {
  if (x < 0 || y < 0 || x >= sensor.depth_mm.width || y >= sensor.depth_mm.height)
    return std::nullopt;
  const int mm = sensor.depth_mm.at(x, y);
  if (mm == 0) return std::nullopt;
  return unproject(*sensor.lens, Eigen::Vector2d(x, y), 1e-3 * mm);
}

std::optional<Eigen::Vector3d> normal_at(const SensorDepth& sensor, int x, int y) {
  const auto left = point_at(sensor, x - kBeside_px, y),
             right = point_at(sensor, x + kBeside_px, y);
  const auto up = point_at(sensor, x, y - kBeside_px), down = point_at(sensor, x, y + kBeside_px);
  if (!left || !right || !up || !down) return std::nullopt;
  const auto is_edge = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::abs(a.z() - b.z()) > kSteepest * a.z();
  };
  if (is_edge(*left, *right) || is_edge(*up, *down)) return std::nullopt;
  return (*right - *left).cross(*down - *up).normalized();
}

/// Pixels for each square metre of a surface at `point`.
double pixels_per_area(const CameraIntrinsics& lens, const Eigen::Vector3d& point,
                       const Eigen::Vector3d& normal) {
  const double cosine = std::abs(normal.dot(point)) / point.norm();
  return lens.fx * lens.fy * std::max(cosine, kMinCosine) / point.squaredNorm();
}

bool shows_better(const SensorDepth& other, const Eigen::Vector3d& world,
                  const Eigen::Vector3d& world_normal, double least,
                  const BetterShownOptions& options) {
  const Eigen::Matrix3d to_other = other.world_from_depth.rotation.transpose();
  const Eigen::Vector3d point = to_other * (world - other.world_from_depth.translation_m);
  if (point.z() <= 0) return false;
  const auto pixel = project(*other.lens, point);
  if (!pixel) return false;
  const auto seen = point_at(other, static_cast<int>(std::lround(pixel->x())),
                             static_cast<int>(std::lround(pixel->y())));
  const double agree = std::max(options.agree_m, options.agree_share * point.z());
  if (!seen || std::abs(seen->z() - point.z()) > agree) return false;
  const Eigen::Vector3d normal = to_other * world_normal;
  const bool is_front = normal.dot(point) < 0;
  return is_front && pixels_per_area(*other.lens, point, normal) > least;
}

}  // namespace

MaskImage better_shown(const std::vector<SensorDepth>& sensors, std::size_t which,
                       const BetterShownOptions& options) {
  const SensorDepth& own = sensors[which];
  MaskImage better(own.depth_mm.width, own.depth_mm.height, 0);
  for (int y = 0; y < own.depth_mm.height; ++y) {
    for (int x = 0; x < own.depth_mm.width; ++x) {
      const auto point = point_at(own, x, y);
      if (!point) continue;
      const auto sloped = normal_at(own, x, y);
      if (!sloped) continue;
      const Eigen::Vector3d normal = sloped->dot(*point) < 0 ? *sloped : Eigen::Vector3d(-*sloped);
      const double least = options.better * pixels_per_area(*own.lens, *point, normal);
      const Eigen::Vector3d world =
          own.world_from_depth.rotation * *point + own.world_from_depth.translation_m;
      const Eigen::Vector3d world_normal = own.world_from_depth.rotation * normal;
      for (std::size_t i = 0; i < sensors.size(); ++i) {
        if (i == which || !shows_better(sensors[i], world, world_normal, least, options)) continue;
        better.at(x, y) = 255;
        break;
      }
    }
  }
  return better;
}

}  // namespace roomcast::bench
