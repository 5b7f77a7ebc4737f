// SPDX-License-Identifier: Apache-2.0
// For tests: poses and exact matches of sensors side by side in front of a printed wall. Metres.
#pragma once

#include <cmath>
#include <vector>

#include "roomcast/alignment/feature/wall_fixture.h"
#include "roomcast/alignment/pair/rigid_fit.h"

namespace roomcast::alignment {

/// The pose of a sensor at `b_x_m` in the frame of one at `a_x_m`.
inline RigidTransform wall_pose(double a_x_m, double b_x_m) {
  RigidTransform a_from_b;
  a_from_b.translation_m.x() = b_x_m - a_x_m;
  return a_from_b;
}

/// Exact matches every 12 cm of what both see of a wall `z_m` ahead.
inline std::vector<PointMatch> wall_matches(const SensorView& a, const SensorView& b,
                                            const RigidTransform& a_from_b, float z_m = 2,
                                            float weight = 1) {
  constexpr float kBetween_m = 0.12F, kHalfWidth = 0.65F,
                  kHalfHeight = 0.5F;  // of the view, at 1 m
  std::vector<PointMatch> matches;
  for (float y = -kHalfHeight * z_m; y < kHalfHeight * z_m; y += kBetween_m) {
    for (float x = -kHalfWidth * z_m; x < kHalfWidth * z_m; x += kBetween_m) {
      const Eigen::Vector3f in_b(x, y, z_m);
      const Eigen::Vector3f in_a = (a_from_b * in_b.cast<double>()).cast<float>();
      if (std::abs(in_a.x()) > kHalfWidth * z_m) continue;
      matches.push_back({in_a, in_b, a.picture.pixel_of(in_a), b.picture.pixel_of(in_b), weight});
    }
  }
  return matches;
}

}  // namespace roomcast::alignment
