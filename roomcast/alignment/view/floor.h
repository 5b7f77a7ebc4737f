// SPDX-License-Identifier: Apache-2.0
// The floor: the largest plane that faces up with nothing below it. "Up" is gravity's opposite
// where the sensor knows it, else roughly up in the picture: sensors stand or hang the right way
// round. Thread-safe (no state).
#pragma once

#include <optional>
#include <span>

#include "roomcast/alignment/view/planes.h"

namespace roomcast::alignment {

/// Without points of its own. Nothing where there is no such plane, for instance when the largest
/// plane that faces up is a table's.
[[nodiscard]] std::optional<Plane> find_floor(std::span<const Plane> planes,
                                              std::span<const SurfacePoint> samples,
                                              const std::optional<Eigen::Vector3d>& up);

}  // namespace roomcast::alignment
