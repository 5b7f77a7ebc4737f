// SPDX-License-Identifier: Apache-2.0
// Refines a pose by up to 16 Gauss-Newton (ICP) steps on about 1500 surface points per view and the
// features that agree, so that hypotheses of the same answer converge and can be compared. Metres.
// Thread-safe (no state).
#pragma once

#include <span>

#include "roomcast/alignment/feature/sensor_view.h"
#include "roomcast/alignment/pair/pair_equations.h"
#include "roomcast/alignment/pair/rigid_fit.h"

namespace roomcast::alignment {

/// Assumed registration of colour to depth. Colour is off by a few pixels where the calibration is
/// slightly wrong or the camera moved between both pictures.
enum class ColorCalibration { kAsCalibrated, kUncertain };

/// Converges from up to about 10 cm away.
[[nodiscard]] PairState refined_pose(const SensorView& a, const SensorView& b,
                                     std::span<const PointMatch> matches,
                                     const RigidTransform& a_from_b,
                                     ColorCalibration color = ColorCalibration::kAsCalibrated);

}  // namespace roomcast::alignment
