// SPDX-License-Identifier: Apache-2.0
// PointCloud: a coloured point cloud with normals. Metres, in one frame of reference. Plain data:
// all three lists have the same length.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "roomcast/core/image.h"

namespace roomcast::recording {

struct PointCloud {
  std::vector<Eigen::Vector3f> points_m;
  std::vector<Eigen::Vector3f> normals;  // unit, towards the sensor
  std::vector<Rgb8> colors;

  [[nodiscard]] std::size_t size() const { return points_m.size(); }
  void clear() {
    points_m.clear();
    normals.clear();
    colors.clear();
  }
  void add(const Eigen::Vector3f& point_m, const Eigen::Vector3f& normal, Rgb8 color) {
    points_m.push_back(point_m);
    normals.push_back(normal);
    colors.push_back(color);
  }
};

}  // namespace roomcast::recording
