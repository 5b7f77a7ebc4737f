// SPDX-License-Identifier: Apache-2.0
// The surface of what moves, at single instants: points with normals, one per block of a
// DepthInstant, from planes through the moving blocks around. Metres, in the depth camera's frame.
// Thread-safe (no state).
#pragma once

#include <vector>

#include "roomcast/alignment/feature/sensor_view.h"

namespace roomcast::alignment {

/// By hand, from the sizes of people and of blocks, which are 3 cm wide at 4 m.
struct MovingSurfaceOptions {
  float same_surface_m = 0.08F;  // neighbours further away along the axis are another surface
  int min_neighbours = 7;        // of nine, the block among them
  float min_incidence = 0.25F;   // cosine; flatter surfaces are smeared edges

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("same_surface_m", same_surface_m, Range{0.001, 10});
    visit("min_neighbours", min_neighbours, Range{3, 9});
    visit("min_incidence", min_incidence, Range{0, 1});
  }
  [[nodiscard]] Status check() const { return check_fields("MovingSurfaceOptions", *this); }
};

struct MovingSurface {
  double time_s = 0;
  Image<SurfacePoint> at;               // by block; the normal is 0 where there is none
  std::vector<Eigen::Vector2i> blocks;  // that have one
};

/// One for each instant of the view.
[[nodiscard]] std::vector<MovingSurface> moving_surfaces(const SensorView& view,
                                                         const MovingSurfaceOptions& options = {});

}  // namespace roomcast::alignment
