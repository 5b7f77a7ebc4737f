// SPDX-License-Identifier: Apache-2.0
// Checks a pose by what moves. What one sensor sees moving must, at the same instant, be seen
// moving at the same place by the other sensor (consistent), or be hidden from it, or be outside
// its picture. Where the other sensor looks through that place, the pose is contradicted: half
// turns and shifts by one shelf put a person where nobody is. Checked both ways. Metres.
// Thread-safe (no state).
#pragma once

#include <cstddef>
#include <span>

#include "roomcast/alignment/feature/sensor_view.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::alignment {

/// By hand, from the sizes of people, who are 0.25 m thick and walk 1.5 m/s.
struct MovingConsistencyOptions {
  double max_apart_s = 0.06;   // instants further apart are not the same
  float same_thing_m = 0.35F;  // sensors may see opposite sides of a person
  float behind_m = 0.35F;      // the other looks through a place if all that it sees is further
  float reach_m = 0.2F;        // around the place, across the line of sight
  float min_seen = 0.7F;       // share of the blocks within reach that have a reading
  std::size_t points = 80;     // of each instant, about
  std::size_t min_blocks = kMinMovingBlocks;  // that move, for the instant to count
  int max_reach_blocks = 12;                  // for time

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("max_apart_s", max_apart_s, Range{0, 10});
    visit("same_thing_m", same_thing_m, Range{0, 10});
    visit("behind_m", behind_m, Range{0, 10});
    visit("reach_m", reach_m, Range{0, 10});
    visit("min_seen", min_seen, Range{0, 1});
    visit("points", points, Range{1, 1e5});
    visit("min_blocks", min_blocks, Range{1, 1e5});
    visit("max_reach_blocks", max_reach_blocks, Range{1, 100});
  }
  [[nodiscard]] Status check() const { return check_fields("MovingConsistencyOptions", *this); }
};

/// Numbers of moving points of both views.
struct MovingConsistency {
  double consistent = 0, violating = 0;
  double possible = 0;  // of instants in which both see something moving: the fewer of both views

  [[nodiscard]] double judged() const { return consistent + violating; }
  [[nodiscard]] double conflict() const { return judged() > 0 ? violating / judged() : 0; }
};

/// The instant nearest to this time; null if none is near enough.
[[nodiscard]] const DepthInstant* instant_at(std::span<const DepthInstant> instants, double time_s,
                                             double max_apart_s);

[[nodiscard]] MovingConsistency check_moving(const SensorView& a, const SensorView& b,
                                             const RigidTransform& a_from_b,
                                             const MovingConsistencyOptions& options = {});

}  // namespace roomcast::alignment
