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

/// `floors_in_origin`: the sensors' floors in the frame of the origin sensor.
[[nodiscard]] WorldFrame world_frame(std::span<const Plane> floors_in_origin);

/// `plane` transformed from frame b to frame a.
[[nodiscard]] Plane transformed(const RigidTransform& a_from_b, const Plane& plane);

}  // namespace roomcast::alignment
