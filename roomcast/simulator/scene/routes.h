// SPDX-License-Identifier: Apache-2.0
// What somebody does in a room in turn, and the ways between: all start from a free place in the
// room's middle, and are kept free of furniture. Metres, seconds; single-threaded.
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
  /// Draws the free place and keeps it free. All three have to outlive it.
  Route(Room& room, FloorPlan& plan, Random& random);

  [[nodiscard]] const Eigen::Vector2f& plaza() const { return plaza_m_; }

  /// Each adds a stop, or says that something stands in the way.
  [[nodiscard]] bool to_sit(const Seat& seat);
  /// A point in the frame of a piece that one stands before.
  [[nodiscard]] bool to_reach(const Eigen::Affine3f& piece, const Eigen::Vector3f& point_m,
                              Activity activity = Activity::kReach, float stay_s = 4.0F);
  /// The same stop again, doing something else.
  void then(Activity activity, float stay_s);

  /// Whoever goes round these stops, looking about in the middle of the room between them.
  [[nodiscard]] Person walker();
  /// Somebody else, if there is place: they stand, or talk with whoever is in the middle.
  [[nodiscard]] std::optional<Person> bystander();

 private:
  [[nodiscard]] bool way_is_free(const Eigen::Vector2f& to_m) const;

  Room& room_;
  FloorPlan& plan_;
  Random& random_;
  Eigen::Vector2f plaza_m_;
  std::vector<Waypoint> stops_;
};

/// The person works at a desk of Furnisher::desk that is pulled up.
[[nodiscard]] Waypoint typing_at(const Eigen::Affine3f& desk);

/// A mesh built by a function that adds to a room, apart from the room's own.
template <class Build>
[[nodiscard]] TriangleMesh built_apart(Room& room, const Build& build) {
  TriangleMesh apart;
  std::swap(room.mesh, apart);
  build();
  std::swap(room.mesh, apart);
  return apart;
}

}  // namespace roomcast::simulator
