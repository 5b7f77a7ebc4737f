// SPDX-License-Identifier: Apache-2.0
// Do both sensors see the same prints on walls, floors and tables? Rooms of one kind are alike in
// shape and pattern, and what tells them apart may be no more than a poster. Over a whole view that
// is one part in a hundred, too little for a mean; so places are counted where both see contrast
// and it is not the same, not even aside, as where colours lie beside their surfaces. On planes
// only: what people do between two frames looks like contradiction everywhere else; and only where
// both colour cameras see the plane itself, not the outline of what stands before it. Where prints
// agree in grey, their hues are compared: how much redder they are where they are brighter, which
// neither exposure nor blur changes. Thread-safe (no state).
#pragma once

#include "roomcast/alignment/feature/sensor_view.h"
#include "roomcast/alignment/pair/pair_equations.h"

namespace roomcast::alignment {

/// Places that could be judged, as shares of a view, of both views together.
struct PlanarTexture {
  double judged = 0;
  double contradicting = 0;
  double agreement = 0;  // the sum of their correlations
  double alike = 0;      // in grey
  double other_hue = 0;  // of those

  void add(const PlanarTexture& other) {
    judged += other.judged;
    contradicting += other.contradicting;
    agreement += other.agreement;
    alike += other.alike;
    other_hue += other.other_hue;
  }
  [[nodiscard]] PlanarTexture over(double points) const {
    return {judged / points, contradicting / points, agreement / points, alike / points,
            other_hue / points};
  }
  [[nodiscard]] double correlation() const { return judged > 0 ? agreement / judged : 0; }
  [[nodiscard]] double conflict() const { return judged > 0 ? contradicting / judged : 0; }
  [[nodiscard]] double hue_conflict() const { return alike > 0 ? other_hue / alike : 0; }
};

/// With colour corrected as the state says.
[[nodiscard]] PlanarTexture compare_planar_texture(const SensorView& a, const SensorView& b,
                                                   const PairState& state);

}  // namespace roomcast::alignment
