// SPDX-License-Identifier: Apache-2.0
// Performance: a person's motion, planned once: pose and burden at any time. The itinerary gives
// the position, the footsteps the feet, and the activities the posture. The hips are as high as the
// planned foot positions allow. A function of time alone. Metres, seconds.
#pragma once

#include <optional>

#include "roomcast/simulator/people/activities.h"
#include "roomcast/simulator/people/footsteps.h"
#include "roomcast/simulator/people/itinerary.h"
#include "roomcast/simulator/people/skeleton.h"

namespace roomcast::simulator {

class Performance {
 public:
  explicit Performance(const Person& person);

  struct Instant {
    Pose pose;
    Eigen::Isometry3f world_from_burden = Eigen::Isometry3f::Identity();
    float held = 0;  // weight of the grip as hand target: 1 while the burden is carried
  };
  [[nodiscard]] Instant at(double time_s) const;

  [[nodiscard]] const Measures& measures() const { return measures_; }
  [[nodiscard]] const Footsteps& footsteps() const { return footsteps_; }
  [[nodiscard]] const Itinerary& itinerary() const { return itinerary_; }
  [[nodiscard]] float round_time(double time_s) const;

  /// Palm position on a burden, in its frame.
  [[nodiscard]] static Eigen::Vector3f grip(const Burden& burden, Side side);

 private:
  struct Moment;  // intermediate values of an instant from which the pose is computed
  [[nodiscard]] Lean lean_at(const Moment& moment) const;
  [[nodiscard]] Eigen::Isometry3f pelvis_at(const Moment& moment) const;
  void place_burden(Moment& moment) const;
  void place_trunk(Moment& moment) const;
  void bend_to_reach(Moment& moment) const;
  [[nodiscard]] Eigen::Isometry3f resting(const Waypoint& stop) const;
  [[nodiscard]] HandGoal hand_at(const Moment& moment, Side side) const;
  [[nodiscard]] HandGoal hanging(const Moment& moment, Side side) const;
  [[nodiscard]] Eigen::Quaternionf head_at(const Moment& moment) const;

  Measures measures_;
  std::vector<Waypoint> stops_;
  std::optional<Burden> burden_;  // without its mesh
  double begin_s_;
  Itinerary itinerary_;
  Footsteps footsteps_;
};

}  // namespace roomcast::simulator
