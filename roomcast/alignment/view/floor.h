// SPDX-License-Identifier: Apache-2.0
// Finds the floor: the largest plane that faces up and has nothing below it. "Up" is opposite to
// gravity where the sensor measures it, else roughly up in the picture, because sensors are mounted
// upright. Thread-safe (no state).
#pragma once

#include <optional>
#include <span>

#include "roomcast/alignment/view/planes.h"

namespace roomcast::alignment {

struct FloorOptions {
  float below_m = 0.08F;               // lower samples are below the plane; beyond depth's bias
  float max_below_share = 0.03F;       // of the samples: flying pixels and reflections; by hand
  float min_cosine_by_picture = 0.5F;  // to up in the picture: a camera may look down by 60 degrees
  float min_cosine_by_gravity = 0.97F;  // to up as measured: 14 degrees, beyond any IMU's error
  float min_height_m = 0.3F;            // of the camera above its floor; by hand

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("below_m", below_m, Range{0, 1});
    visit("max_below_share", max_below_share, Range{0, 1});
    visit("min_cosine_by_picture", min_cosine_by_picture, Range{0, 1});
    visit("min_cosine_by_gravity", min_cosine_by_gravity, Range{0, 1});
    visit("min_height_m", min_height_m, Range{0, 10});
  }
  [[nodiscard]] Status check() const { return check_fields("FloorOptions", *this); }
};

/// The floor without its points; nothing where there is no such plane, for instance when the only
/// plane that faces up is a table's.
[[nodiscard]] std::optional<Plane> find_floor(std::span<const Plane> planes,
                                              std::span<const SurfacePoint> samples,
                                              const std::optional<Eigen::Vector3d>& up,
                                              const FloorOptions& options = {});

}  // namespace roomcast::alignment
