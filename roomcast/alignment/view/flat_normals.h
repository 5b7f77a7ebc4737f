// SPDX-License-Identifier: Apache-2.0
// Replaces the normals of points on large planes by the plane's exact normal. A normal is measured
// over a few pixels, so noise and the sensor's smooth errors tilt it by degrees. Wrongly tilted
// floor normals constrain a pose sideways and pull it along the floor: by more than a hand's
// breadth in a room with little else in it. Metres. Thread-safe (no state).
#pragma once

#include <span>

#include "roomcast/alignment/view/depth_surface.h"
#include "roomcast/alignment/view/planes.h"

namespace roomcast::alignment {

/// Chosen on simulated rooms with little but a floor.
struct FlatNormalOptions {
  float thickness_m = 0.02F;  // from the plane, in addition to the depth noise
  float min_cosine = 0.98F;   // between normals; a larger tilt is real

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("thickness_m", thickness_m, Range{0, 1});
    visit("min_cosine", min_cosine, Range{-1, 1});
  }
  [[nodiscard]] Status check() const { return check_fields("FlatNormalOptions", *this); }
};

/// Sets the normal of every point on one of the planes to that plane's normal.
void flatten_normals(std::span<const Plane> planes, DepthSurface& surface,
                     const FlatNormalOptions& options = {});

}  // namespace roomcast::alignment
