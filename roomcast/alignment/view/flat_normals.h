// SPDX-License-Identifier: Apache-2.0
// Normals on large planes, made exact. A normal is measured over a few pixels, so noise and the
// sensor's smooth errors tilt it by degrees; a floor that is thought to be tilted here and there
// seems to hold a pose sideways, and pulls it along itself: in a room with little else in it by
// more than a hand's breadth. Metres. Thread-safe (no state).
#pragma once

#include <span>

#include "roomcast/alignment/view/depth_surface.h"
#include "roomcast/alignment/view/planes.h"

namespace roomcast::alignment {

/// Gives every point that lies on one of the planes that plane's normal.
void flatten_normals(std::span<const Plane> planes, DepthSurface& surface);

}  // namespace roomcast::alignment
