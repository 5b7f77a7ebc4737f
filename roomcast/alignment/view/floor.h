// SPDX-License-Identifier: Apache-2.0
// Finds the floor: the largest plane that faces up and has nothing below it. "Up" is opposite to
// gravity where the sensor measures it, else roughly up in the picture, because sensors are mounted
// upright. Thread-safe (no state).
#pragma once

#include <optional>
#include <span>

#include "roomcast/alignment/view/planes.h"

namespace roomcast::alignment {

/// The floor without its points; nothing where there is no such plane, for instance when the only
/// plane that faces up is a table's.
[[nodiscard]] std::optional<Plane> find_floor(std::span<const Plane> planes,
                                              std::span<const SurfacePoint> samples,
                                              const std::optional<Eigen::Vector3d>& up);

}  // namespace roomcast::alignment
