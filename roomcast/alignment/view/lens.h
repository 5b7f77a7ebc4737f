// SPDX-License-Identifier: Apache-2.0
// Lens: the camera model of geometry/camera_model.h in single precision, because alignment computes
// millions of projections. Points beyond the widest ray of the picture have no projection, because
// the lens polynomial is not valid there. Metres, pixels. Thread-safe (immutable).
#pragma once

#include <Eigen/Core>

#include "roomcast/geometry/camera_model.h"

namespace roomcast::alignment {

class Lens {
 public:
  /// `camera` must have been checked.
  explicit Lens(const CameraIntrinsics& camera);

  /// Returns whether the point is in front of the camera and within its widest ray; if so, sets
  /// `pixel`.
  [[nodiscard]] bool project(const Eigen::Vector3f& point_m, Eigen::Vector2f& pixel) const {
    if (!(point_m.z() > kNearest_m)) return false;
    const Eigen::Vector2f xy = point_m.head<2>() / point_m.z();
    const float r2 = xy.squaredNorm();
    if (!(r2 <= largest_r2_)) return false;
    const float radial = 1 + r2 * (k1_ + r2 * (k2_ + r2 * k3_));
    const float cross = 2 * xy.x() * xy.y();
    pixel.x() = fx_ * (xy.x() * radial + p1_ * cross + p2_ * (r2 + 2 * xy.x() * xy.x())) + cx_;
    pixel.y() = fy_ * (xy.y() * radial + p1_ * (r2 + 2 * xy.y() * xy.y()) + p2_ * cross) + cy_;
    return true;
  }

 private:
  static constexpr float kNearest_m = 0.2F;  // no depth sensor measures nearer
  float fx_, fy_, cx_, cy_, k1_, k2_, k3_, p1_, p2_, largest_r2_;
};

}  // namespace roomcast::alignment
