// SPDX-License-Identifier: Apache-2.0
// The room's world frame: y up, the floor at y = 0. Every placed sensor that sees the floor
// contributes its own floor plane; the floors that agree give the median height and the mean
// normal. The origin sensor is at x = z = 0 and looks along -z. Metres. Thread-safe (no state).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "roomcast/alignment/view/planes.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::alignment {

struct WorldFrame {
  RigidTransform world_from_origin;
  bool has_floor = false;  // else the vertical is that of the origin sensor's picture
};

struct WorldFrameOptions {
  float agree_cosine = 0.9962F;  // between the normals of floors that agree: 5 degrees; by hand
  float agree_height_m = 0.10F;  // between their heights: no table is as low; by hand

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("agree_cosine", agree_cosine, Range{-1, 1});
    visit("agree_height_m", agree_height_m, Range{0, 10});
  }
  [[nodiscard]] Status check() const { return check_fields("WorldFrameOptions", *this); }
};

/// `floors_in_origin`: the sensors' floors in the frame of the origin sensor.
[[nodiscard]] WorldFrame world_frame(std::span<const Plane> floors_in_origin,
                                     const WorldFrameOptions& options = {});

/// `plane` transformed from frame b to frame a.
[[nodiscard]] Plane transformed(const RigidTransform& a_from_b, const Plane& plane);

}  // namespace roomcast::alignment
