// SPDX-License-Identifier: Apache-2.0
// Compares the texture that two sensors see on walls, floors and tables. Rooms of one kind are
// alike in shape and pattern and may differ by no more than a poster. Over a whole view that is one
// part in a hundred, too little for a mean. Therefore places are counted where both sensors see
// contrast but different patterns, even when shifted (colours may be misaligned with their
// surfaces). Only planes count, because people moving between two frames look like contradictions
// everywhere else. Both colour cameras must see the plane itself, not the outline of an object in
// front of it. Where greys agree, hues are compared: the slope of redness over brightness, which
// neither exposure nor blur changes. Thread-safe (no state).
#pragma once

#include "roomcast/alignment/feature/sensor_view.h"
#include "roomcast/alignment/pair/pair_equations.h"

namespace roomcast::alignment {

/// Counts of judged places, as shares of a view, for both views together.
struct PlanarTexture {
  double judged = 0;
  double contradicting = 0;
  double agreement = 0;      // sum of the judged places' correlations
  double alike = 0;          // places alike in grey
  double different_hue = 0;  // places alike in grey but of another hue

  void add(const PlanarTexture& other) {
    judged += other.judged;
    contradicting += other.contradicting;
    agreement += other.agreement;
    alike += other.alike;
    different_hue += other.different_hue;
  }
  [[nodiscard]] PlanarTexture over(double points) const {
    return {judged / points, contradicting / points, agreement / points, alike / points,
            different_hue / points};
  }
  [[nodiscard]] double correlation() const { return judged > 0 ? agreement / judged : 0; }
  [[nodiscard]] double conflict() const { return judged > 0 ? contradicting / judged : 0; }
  [[nodiscard]] double hue_conflict() const { return alike > 0 ? different_hue / alike : 0; }
};

/// Colour is corrected by the state's shifts.
[[nodiscard]] PlanarTexture compare_planar_texture(const SensorView& a, const SensorView& b,
                                                   const PairState& state);

}  // namespace roomcast::alignment
