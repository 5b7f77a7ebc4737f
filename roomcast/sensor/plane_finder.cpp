// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/plane_finder.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace roomcast::sensor {

bool is_near(const Plane& plane, const Eigen::Vector3f& point_m, float reach) {
  const float off = std::abs(plane.normal.dot(point_m) - plane.distance_m);
  const float facing = std::abs(plane.normal.dot(point_m.normalized()));
  // The tolerance is one of depth, so it counts less at a flat angle.
  return off < reach * plane_tolerance_m(point_m.z()) * std::max(facing, 0.15F);
}

namespace {

constexpr int kStep_px = 6;  // between points, and between those of which a normal is made
constexpr int kMaxPlanes = 5, kCandidates = 240, kRefinements = 3;
constexpr double kMinShare = 0.03;
constexpr std::size_t kMinPoints = 80;
constexpr float kMaxStep = 0.1F;     // of depth, between neighbouring points of a surface
constexpr float kMinFacing = 0.05F;  // cosine

struct OrientedPoint {
  Eigen::Vector3f at, normal;
};

std::optional<Eigen::Vector3f> point_at(DepthView depth_mm, const Image<Eigen::Vector2f>& rays,
                                        int x, int y) {
  const std::uint16_t reading = depth_mm.at(x, y);
  const Eigen::Vector2f& ray = rays.at(x, y);
  if (reading == 0 || !ray.allFinite()) return std::nullopt;
  const float z_m = 0.001F * static_cast<float>(reading);
  return Eigen::Vector3f(z_m * ray.x(), z_m * ray.y(), z_m);
}

std::vector<OrientedPoint> points_of(DepthView depth_mm, const Image<Eigen::Vector2f>& rays) {
  std::vector<OrientedPoint> points;
  for (int y = 0; y + kStep_px < depth_mm.height; y += kStep_px) {
    for (int x = 0; x + kStep_px < depth_mm.width; x += kStep_px) {
      const auto here = point_at(depth_mm, rays, x, y);
      const auto right = point_at(depth_mm, rays, x + kStep_px, y);
      const auto below = point_at(depth_mm, rays, x, y + kStep_px);
      if (!here || !right || !below) continue;
      const float most = kMaxStep * here->z();
      if (std::abs(right->z() - here->z()) > most || std::abs(below->z() - here->z()) > most)
        continue;
      const Eigen::Vector3f normal = (*right - *here).cross(*below - *here);
      if (normal.norm() < 1e-9F) continue;
      points.push_back({*here, normal.normalized()});
    }
  }
  return points;
}

bool is_on(const Plane& plane, const OrientedPoint& point) {
  return is_near(plane, point.at, 1);
}

/// Least squares over weighted points.
class PlaneFit {
 public:
  void add(const Eigen::Vector3f& point_m, double weight) {
    const Eigen::Vector3d at = point_m.cast<double>();
    sum_ += weight * at;
    squares_ += weight * at * at.transpose();
    weight_ += weight;
    ++points_;
  }
  [[nodiscard]] std::optional<Plane> plane() const {
    if (points_ < kMinPoints || weight_ <= 0) return std::nullopt;
    const Eigen::Vector3d mean = sum_ / weight_;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(squares_ / weight_ -
                                                              mean * mean.transpose());
    const Eigen::Vector3d normal = axes.eigenvectors().col(0);
    return Plane{normal.cast<float>(), static_cast<float>(normal.dot(mean))};
  }

 private:
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares_ = Eigen::Matrix3d::Zero();
  double weight_ = 0;
  std::size_t points_ = 0;
};

std::optional<Plane> fitted_to(const std::vector<OrientedPoint>& points, const Plane& near) {
  PlaneFit fit;
  for (const OrientedPoint& point : points) {
    if (is_on(near, point)) fit.add(point.at, 1);
  }
  return fit.plane();
}

std::size_t count_on(const std::vector<OrientedPoint>& points, const Plane& plane) {
  return static_cast<std::size_t>(std::ranges::count_if(
      points, [&](const OrientedPoint& point) { return is_on(plane, point); }));
}

/// Of every fourth point: enough to compare candidates.
std::size_t count_on_some(const std::vector<OrientedPoint>& points, const Plane& plane) {
  constexpr std::size_t kEvery = 4;
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); i += kEvery) count += is_on(plane, points[i]);
  return count;
}

std::optional<Plane> largest(const std::vector<OrientedPoint>& points, std::minstd_rand& random) {
  std::optional<Plane> best;
  std::size_t most = 0;
  for (int i = 0; i < kCandidates && !points.empty(); ++i) {
    const OrientedPoint& point = points[random() % points.size()];
    if (std::abs(point.normal.dot(point.at.normalized())) < kMinFacing) continue;
    const Plane plane{point.normal, point.normal.dot(point.at)};
    const std::size_t count = count_on_some(points, plane);
    if (count <= most) continue;
    most = count;
    best = plane;
  }
  for (int i = 0; best && i < kRefinements; ++i) best = fitted_to(points, *best);
  return best;
}

}  // namespace

Plane refined(const Plane& plane, const std::vector<Eigen::Vector3f>& points_m,
              const std::vector<float>& weights, float reach) {
  constexpr int kRounds = 4;
  Plane best = plane;
  for (int round = 0; round < kRounds; ++round) {
    const float within = reach + (1 - reach) * static_cast<float>(round) / (kRounds - 1);
    PlaneFit fit;
    for (std::size_t i = 0; i < points_m.size(); ++i) {
      if (is_near(best, points_m[i], within)) fit.add(points_m[i], static_cast<double>(weights[i]));
    }
    const auto next = fit.plane();
    if (!next) return plane;
    best = *next;
  }
  return best;
}

std::vector<Plane> find_planes(DepthView depth_mm, const Image<Eigen::Vector2f>& rays) {
  std::vector<OrientedPoint> points = points_of(depth_mm, rays);
  const auto least = std::max(
      kMinPoints, static_cast<std::size_t>(kMinShare * static_cast<double>(points.size())));
  std::minstd_rand random(1);
  std::vector<Plane> planes;
  while (planes.size() < kMaxPlanes) {
    const auto plane = largest(points, random);
    if (!plane || count_on(points, *plane) < least) break;
    planes.push_back(*plane);
    std::erase_if(points, [&](const OrientedPoint& point) { return is_on(*plane, point); });
  }
  return planes;
}

}  // namespace roomcast::sensor
