// SPDX-License-Identifier: Apache-2.0
// Point-to-plane residuals (Chen & Medioni 1992) between the surfaces of two views. A point of one
// is looked up in the other's depth picture (projective association, Blais & Levine 1995): no
// search tree, and what one camera cannot see is not forced onto what it can. Both ways, weighted
// by the depth noise of both readings. Metres. Thread-safe (no state).
#pragma once

#include <vector>

#include "roomcast/align/pair/pair_equations.h"
#include "roomcast/align/view/depth_surface.h"

namespace roomcast::align {

struct SurfaceResidualOptions {
  float reach_m = 0.05F;      // along the normal; what is further away is another surface
  std::size_t points = 6000;  // of each view, at most
  double noise = 1;           // how noisy these two are, as a multiple of depth_sigma_m
};

/// What both surfaces say. Neighbouring readings err together, so all of them count as no more than
/// about 1500 independent ones.
[[nodiscard]] PairEquations surface_equations(const DepthSurface& a, const DepthSurface& b,
                                              const RigidTransform& a_from_b,
                                              const SurfaceResidualOptions& options);

/// How noisy these surfaces are at this pose, for SurfaceResidualOptions::noise: from the median
/// residual, within reason.
[[nodiscard]] double surface_noise(const DepthSurface& a, const DepthSurface& b,
                                   const RigidTransform& a_from_b,
                                   const SurfaceResidualOptions& options);

/// Distances along the normal (with sign, metres) at all points that both see.
[[nodiscard]] std::vector<float> surface_residuals_m(const DepthSurface& a, const DepthSurface& b,
                                                     const RigidTransform& a_from_b,
                                                     const SurfaceResidualOptions& options);

}  // namespace roomcast::align
