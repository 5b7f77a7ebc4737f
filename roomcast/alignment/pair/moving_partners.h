// SPDX-License-Identifier: Apache-2.0
// Surfaces that move, seen by two sensors at the same instant: partners for point-to-plane
// residuals, like those of what stands still (surface_residuals.h). They lie in the middle of a
// room, between its sensors, where nothing else tells a depth that reads too far from a sensor that
// stands further away. Metres. Thread-safe (no state).
#pragma once

#include <vector>

#include "roomcast/alignment/feature/sensor_view.h"
#include "roomcast/alignment/pair/moving_consistency.h"
#include "roomcast/alignment/pair/surface_residuals.h"

namespace roomcast::alignment {

/// By hand.
struct MovingPartnerOptions {
  float min_cosine = 0.5F;         // between the normals of partners
  float slide_per_reach = 2;       // a partner may be so much further away along the surface
  double surface_sigma_m = 0.015;  // of coarse surfaces: folds of clothes
  double speed_m_s = 0.7;          // of what moves, between instants that are not quite the same
  double per_instant = 25;         // partners of an instant that err independently, at most
  double most = 400;               // of a pair

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("min_cosine", min_cosine, Range{-1, 1});
    visit("slide_per_reach", slide_per_reach, Range{0, 1000});
    visit("surface_sigma_m", surface_sigma_m, Range{1e-4, 1});
    visit("speed_m_s", speed_m_s, Range{0, 100});
    visit("per_instant", per_instant, Range{1, 1e6});
    visit("most", most, Range{1, 1e6});
  }
  [[nodiscard]] Status check() const { return check_fields("MovingPartnerOptions", *this); }
};

struct MovingPartners {
  std::vector<SurfacePartner> partners;  // points with their sensors' scales applied
  double independent = 0;                // of their errors
};

/// `scale_a`, `scale_b`: factors on the sensors' readings. `reach_m`: largest residual.
[[nodiscard]] MovingPartners moving_partners(const SensorView& a, double scale_a,
                                             const SensorView& b, double scale_b,
                                             const RigidTransform& a_from_b, float reach_m,
                                             const MovingPartnerOptions& options = {},
                                             const MovingConsistencyOptions& moving = {});

}  // namespace roomcast::alignment
