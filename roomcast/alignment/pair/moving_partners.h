// SPDX-License-Identifier: Apache-2.0
// Surfaces that move, seen by two sensors at the same instant: partners for point-to-plane
// residuals, like those of what stands still (surface_residuals.h). They lie in the middle of a
// room, between its sensors, where nothing else tells a depth that reads too far from a sensor that
// stands further away. A partner is the nearest point around where the other sensor would see it,
// and residuals are along the mean of both normals, because sensors see a person from different
// sides. Both ways. Metres. Thread-safe (no state).
#pragma once

#include <span>
#include <vector>

#include "roomcast/alignment/pair/moving_surface.h"
#include "roomcast/alignment/pair/surface_residuals.h"

namespace roomcast::alignment {

/// By hand.
struct MovingPartnerOptions {
  double max_apart_s = 0.06;      // instants further apart are not the same
  float min_cosine = 0.5F;        // between the normals of partners
  float slide_per_reach = 2;      // a partner may be so much further away along the surface
  int window = 3;                 // blocks around the place where a partner is sought
  std::size_t points = 4000;      // of each view of a pair, about, over all instants
  double surface_sigma_m = 0.02;  // of coarse surfaces: folds of clothes, blocks of pixels

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("max_apart_s", max_apart_s, Range{0, 10});
    visit("min_cosine", min_cosine, Range{-1, 1});
    visit("slide_per_reach", slide_per_reach, Range{0, 1000});
    visit("window", window, Range{0, 100});
    visit("points", points, Range{1, 1e6});
    visit("surface_sigma_m", surface_sigma_m, Range{1e-4, 1});
  }
  [[nodiscard]] Status check() const { return check_fields("MovingPartnerOptions", *this); }
};

/// A sensor that sees something moving.
struct MovingSide {
  const Lens& lens;
  std::span<const MovingSurface> surfaces;
  double scale = 1;  // factor on the readings
};

struct MovingPartners {
  std::vector<SurfacePartner> partners;  // points as measured; normals in a's frame, unit
  std::size_t instants = 0;              // that have some
};

/// `reach_m`: largest residual.
[[nodiscard]] MovingPartners moving_partners(const MovingSide& a, const MovingSide& b,
                                             const RigidTransform& a_from_b, float reach_m,
                                             const MovingPartnerOptions& options = {});

}  // namespace roomcast::alignment
