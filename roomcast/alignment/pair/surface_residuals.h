// SPDX-License-Identifier: Apache-2.0
// Point-to-plane residuals (Chen & Medioni 1992) between the surfaces of two views. A point of one
// is looked up in the other's depth picture (projective association, Blais & Levine 1995). That
// needs no search tree, and surfaces hidden from one camera are not forced onto visible ones. Both
// ways, weighted by the depth noise of both readings. Metres. Thread-safe (no state).
#pragma once

#include <span>
#include <vector>

#include "roomcast/alignment/pair/pair_equations.h"
#include "roomcast/alignment/pair/patch_scores.h"
#include "roomcast/alignment/view/depth_surface.h"

namespace roomcast::alignment {

struct SurfaceReach {
  float reach_m = 0.05F;      // along the normal; points further away are on another surface
  std::size_t points = 6000;  // of each view, about
};

/// Chosen on the development rooms (alignment_options.h), unless noted.
struct SurfaceResidualOptions {
  float min_cosine = 0.8F;        // between the normals of partners
  float slide_per_reach = 4;      // a partner may be so much further away along the surface
  double max_independent = 1500;  // partners: errors of neighbours are correlated; the prototype's
  /// Limits of the estimated noise, in units of the depth noise.
  double min_noise = 0.2, max_noise = 1.5;

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("min_cosine", min_cosine, Range{-1, 1});
    visit("slide_per_reach", slide_per_reach, Range{0, 1000});
    visit("max_independent", max_independent, Range{1, 1e7});
    visit("min_noise", min_noise, Range{0.001, 1000});
    visit("max_noise", max_noise, Range{0.001, 1000});
  }
  [[nodiscard]] Status check() const {
    if (Status status = check_fields("SurfaceResidualOptions", *this); !status) return status;
    return check_at_most("SurfaceResidualOptions", "min_noise", min_noise, "max_noise", max_noise);
  }
};

/// A surface point of one sensor and its partner in the other's view.
struct SurfacePartner {
  Eigen::Vector3f a_m, b_m;  // as measured, in the depth frames
  Eigen::Vector3f normal;    // of the looked-up point, in a's frame
  float residual_m = 0;      // along the normal, from a's point to b's
  float variance_m2 = 0;     // of depth noise, mean of both readings
};

/// Partners of all sampled points that both views see.
[[nodiscard]] std::vector<SurfacePartner> surface_partners(
    const DepthSurface& a, const DepthSurface& b, const RigidTransform& a_from_b,
    const SurfaceReach& reach, const SurfaceResidualOptions& options = {});

/// Equations of the partners, for surfaces `noise` times as noisy as assumed (view/depth_noise.h).
/// Errors of neighbouring readings are correlated, so all partners count as no more than so many
/// independent ones.
[[nodiscard]] PairEquations surface_equations(std::span<const SurfacePartner> partners,
                                              const RigidTransform& a_from_b, double noise,
                                              const SurfaceResidualOptions& options = {});

/// Adds the terms of surface_equations to `scores`, per patch.
void add_surface_scores(std::span<const SurfacePartner> partners, const RigidTransform& a_from_b,
                        double noise, PairScores& scores,
                        const SurfaceResidualOptions& options = {});

/// Noise of the partners at this pose, in units of the depth noise, from the median residual,
/// within the limits.
[[nodiscard]] double surface_noise(std::span<const SurfacePartner> partners,
                                   const SurfaceResidualOptions& options = {});

/// Value of `noise` to use before it is estimated.
inline constexpr double kUsualNoise = 1;

}  // namespace roomcast::alignment
