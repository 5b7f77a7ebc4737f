// SPDX-License-Identifier: Apache-2.0
// Route: builds a person's waypoints and the paths between them. All paths start at a free place
// near the room's centre and are kept free of furniture. Metres, seconds; single-threaded.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "roomcast/simulator/random/random.h"
#include "roomcast/simulator/scene/floor_plan.h"
#include "roomcast/simulator/scene/furnisher.h"

namespace roomcast::simulator {

class Route {
 public:
  /// Draws the free place and keeps it free. All three arguments must outlive the Route.
  Route(Room& room, FloorPlan& plan, Random& random);

  [[nodiscard]] const Eigen::Vector2f& plaza() const { return plaza_m_; }

  /// Each call adds a waypoint; false if the path is blocked.
  [[nodiscard]] bool to_sit(const Seat& seat);
  /// `point_m`: in the frame of the piece of furniture; the person stands in front of it.
  [[nodiscard]] bool to_reach(const Eigen::Affine3f& piece, const Eigen::Vector3f& point_m,
                              Activity activity = Activity::kReach, float stay_s = 4.0F);
  /// Adds the same waypoint again with another activity.
  void then(Activity activity, float stay_s);

  /// A person who visits these waypoints and looks around at the room's centre between them.
  [[nodiscard]] Person walker();
  /// A second person, if there is space: stands, or talks to a person at the centre.
  [[nodiscard]] std::optional<Person> bystander();

 private:
  [[nodiscard]] bool way_is_free(const Eigen::Vector2f& to_m) const;

  Room& room_;
  FloorPlan& plan_;
  Random& random_;
  Eigen::Vector2f plaza_m_;
  std::vector<Waypoint> stops_;
};

/// A person working at a desk of Furnisher::desk with `pulled_up`.
[[nodiscard]] Waypoint typing_at(const Eigen::Affine3f& desk);

/// Builds a mesh with a function that adds to a room, separate from the room's own mesh.
template <class Build>
[[nodiscard]] TriangleMesh built_apart(Room& room, const Build& build) {
  TriangleMesh apart;
  std::swap(room.mesh, apart);
  build();
  std::swap(room.mesh, apart);
  return apart;
}

}  // namespace roomcast::simulator
