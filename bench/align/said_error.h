// SPDX-License-Identifier: Apache-2.0
// The error that alignment expects of one sensor relative to another one. Millimetres where a name
// says so. Thread-safe (no state).
#pragma once

#include <span>

#include <Eigen/Core>

#include "roomcast/alignment/rig/alignment_report.h"

namespace roomcast::bench {

/// One standard deviation of b's pose relative to a's, 2.5 m ahead of b, against exact poses: with
/// the error of the room's scale, which grows with the distance from a. The report says 0 of the
/// rig's origin, which may be either of the two sensors.
[[nodiscard]] double said_of(const alignment::SensorReport& a, const alignment::SensorReport& b,
                             const RigidTransform& a_from_b, double scale_error);

/// The share of errors, each divided by what was said, that are at most twice that. 0 of none.
[[nodiscard]] double share_within_twice(std::span<const double> errors_over_said);

}  // namespace roomcast::bench
