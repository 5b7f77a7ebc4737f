// SPDX-License-Identifier: Apache-2.0
// A peer method that uses shape only: FPFH features (Rusu et al. 2009), the pose by RANSAC over
// their matches with the edge-length check of Buch et al. (ICRA 2013), then point-to-plane ICP.
// Metres. Thread-safe (no state).
#pragma once

#include <optional>

#include "roomcast/alignment/feature/sensor_view.h"

namespace roomcast::bench {

/// a_from_b. Nothing when too few features match.
[[nodiscard]] std::optional<RigidTransform> fpfh_ransac_pose(const alignment::SensorView& a,
                                                             const alignment::SensorView& b);

}  // namespace roomcast::bench
