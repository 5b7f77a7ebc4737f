// SPDX-License-Identifier: Apache-2.0
// PlaneFinder: the large planes in front of a depth sensor, such as floor, walls and tables: random
// sampling of points with their normals (Fischler and Bolles 1981; oriented points as Schnabel,
// Wahl and Klein 2007), refined by least squares over the inliers. Sensor's frame, metres. The same
// picture gives the same planes. Thread-safe (no state).
#pragma once

#include <vector>

#include <Eigen/Core>

#include "roomcast/core/image.h"

namespace roomcast::sensor {

struct Plane {
  Eigen::Vector3f normal;  // unit length
  float distance_m = 0;    // normal * point == distance_m

  /// Depth at which a pixel's ray (x/z, y/z) meets the plane; 0 if it does not, or almost parallel.
  [[nodiscard]] float depth_m(const Eigen::Vector2f& ray) const {
    const float along = normal.x() * ray.x() + normal.y() * ray.y() + normal.z();
    return along * distance_m > 1e-4F ? distance_m / along : 0.0F;
  }
};

/// Readings of a plane differ from it by less.
[[nodiscard]] inline float plane_tolerance_m(float depth_m) {
  return 0.02F + 0.02F * depth_m;
}

/// Whether a point is within `reach` tolerances of a plane.
[[nodiscard]] bool is_near(const Plane& plane, const Eigen::Vector3f& point_m, float reach);

/// The plane through points near one: of `points_m` those within `reach` tolerances, in steps down
/// to one, each with its weight. Unchanged where too few points are near.
[[nodiscard]] Plane refined(const Plane& plane, const std::vector<Eigen::Vector3f>& points_m,
                            const std::vector<float>& weights, float reach);

/// `rays`: ray_table of the depth camera. The plane with most readings comes first; at most five,
/// each with at least 3 % of the readings.
[[nodiscard]] std::vector<Plane> find_planes(DepthView depth_mm,
                                             const Image<Eigen::Vector2f>& rays);

}  // namespace roomcast::sensor
