// SPDX-License-Identifier: Apache-2.0
// A peer method: SIFT features matched by Lowe's ratio test, the features of one view lifted to 3D
// by its depth, the pose by perspective-n-point RANSAC (OpenCV). Metres. Thread-safe (no state).
#pragma once

#include <optional>

#include "roomcast/alignment/feature/sensor_view.h"

namespace roomcast::bench {

/// a_from_b, or nothing when too few matches agree.
[[nodiscard]] std::optional<RigidTransform> sift_pnp_pose(const alignment::SensorView& a,
                                                          const alignment::SensorView& b);

}  // namespace roomcast::bench
