// SPDX-License-Identifier: Apache-2.0
// The large planes of a view (RANSAC, Fischler & Bolles 1981, with hypotheses from single points
// with normals, drawn in a fixed order). Metres in the depth camera's frame. Thread-safe (no
// state).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "roomcast/alignment/view/depth_surface.h"

namespace roomcast::alignment {

struct Plane {
  Eigen::Vector3f normal;                 // unit, towards the camera
  float offset_m = 0;                     // normal . point + offset == 0
  std::vector<Eigen::Vector3f> points_m;  // samples on the plane

  [[nodiscard]] float height_m(const Eigen::Vector3f& point_m) const {
    return normal.dot(point_m) + offset_m;
  }
};

inline constexpr std::size_t kMaxPlanes = 8;
/// Share of the samples; smaller planes are dropped.
inline constexpr float kSmallestPlaneShare = 0.03F;

/// In the order found, each the largest found among the remaining samples. Order and planes depend
/// on the samples only.
[[nodiscard]] std::vector<Plane> find_planes(std::span<const SurfacePoint> samples);

}  // namespace roomcast::alignment
