// SPDX-License-Identifier: Apache-2.0
// Lets a hypothesis settle: a few quick steps on few surface points and the features that agree, so
// that hypotheses which mean the same end up the same, and can be judged. Metres. Thread-safe (no
// state).
#pragma once

#include <span>

#include "roomcast/alignment/feature/sensor_view.h"
#include "roomcast/alignment/pair/pair_equations.h"
#include "roomcast/alignment/pair/rigid_fit.h"

namespace roomcast::alignment {

/// Where a sensor's colour is thought to lie. It is a few pixels aside of depth where the
/// calibration is a little off, or the camera moved between both.
enum class ColorCalibration { kAsCalibrated, kUncertain };

/// From up to about 10 cm away.
[[nodiscard]] PairState refined_pose(const SensorView& a, const SensorView& b,
                                     std::span<const PointMatch> matches,
                                     const RigidTransform& a_from_b,
                                     ColorCalibration color = ColorCalibration::kAsCalibrated);

}  // namespace roomcast::alignment
