// SPDX-License-Identifier: Apache-2.0
// Footsteps: foot placements and the times of lifting and setting down, planned once for a whole
// round of an itinerary so that feet never slide. Steps alternate at a constant beat; a foot is set
// down below the body's position half-way through its stance, and is not lifted if it is already
// near that. Metres, seconds.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "roomcast/simulator/people/itinerary.h"
#include "roomcast/simulator/people/skeleton.h"

namespace roomcast::simulator {

class Footsteps {
 public:
  Footsteps(const Itinerary& itinerary, const Measures& measures);

  struct Foot {
    Eigen::Isometry3f ankle;  // world_from_foot
    bool planted;             // heel or ball is fixed on the floor
    Eigen::Vector3f pivot_m;  // point of the sole, in the foot's frame, about which it rolls
  };
  [[nodiscard]] Foot foot_at(float time_s, Side side) const;

  /// Phase of the gait: one turn per two steps, 0 when the left foot is lifted.
  [[nodiscard]] float phase_at(float time_s) const;

 private:
  struct Placement {
    Eigen::Vector2f at_m;
    float heading_rad;
  };
  struct Step {
    Placement from, to;
    bool lifted = false;
  };
  [[nodiscard]] Placement wanted(const Itinerary& itinerary, float time_s, Side side) const;
  [[nodiscard]] std::size_t last_slot(float time_s, Side side) const;
  [[nodiscard]] float since_slot(float time_s, std::size_t slot) const;
  [[nodiscard]] Eigen::Isometry3f rolled(const Placement& at, float lift_m, float roll_rad) const;

  Measures measures_;
  float period_s_;
  float beat_s_;
  std::vector<Step> steps_;  // even indices: left foot
};

}  // namespace roomcast::simulator
