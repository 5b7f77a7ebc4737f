// SPDX-License-Identifier: Apache-2.0
// Point-to-plane residuals (Chen & Medioni 1992) between the surfaces of two views. A point of one
// is looked up in the other's depth picture (projective association, Blais & Levine 1995): no
// search tree, and what one camera cannot see is not forced onto what it can. Both ways, weighted
// by the depth noise of both readings. Metres. Thread-safe (no state).
#pragma once

#include <span>
#include <vector>

#include "roomcast/alignment/pair/pair_equations.h"
#include "roomcast/alignment/pair/patch_scores.h"
#include "roomcast/alignment/view/depth_surface.h"

namespace roomcast::alignment {

struct SurfaceReach {
  float reach_m = 0.05F;      // along the normal; what is further away is another surface
  std::size_t points = 6000;  // of each view, at most
};

/// A point that one sensor sees, and what the other sees there.
struct SurfacePartner {
  Eigen::Vector3f a_m, b_m;  // as measured, in the depth frames
  Eigen::Vector3f normal;    // of the one that was looked up, in a's frame
  float residual_m = 0;      // along it, from a's to b's
  float variance_m2 = 0;     // of the depth noise of both
};

/// At all points that both see.
[[nodiscard]] std::vector<SurfacePartner> surface_partners(const DepthSurface& a,
                                                           const DepthSurface& b,
                                                           const RigidTransform& a_from_b,
                                                           const SurfaceReach& reach);

/// What both surfaces say, if they are `noise` times as noisy as depth_sigma_m. Neighbouring
/// readings err together, so all of them count as no more than about 1500 independent ones.
[[nodiscard]] PairEquations surface_equations(std::span<const SurfacePartner> partners,
                                              const RigidTransform& a_from_b, double noise);

/// The terms of surface_equations, by patches.
void add_surface_scores(std::span<const SurfacePartner> partners, const RigidTransform& a_from_b,
                        double noise, PairScores& scores);

/// How noisy these surfaces are at this pose: from the median residual, within reason.
[[nodiscard]] double surface_noise(std::span<const SurfacePartner> partners);

/// Before anything is known about it.
inline constexpr double kUsualNoise = 1;

}  // namespace roomcast::alignment
