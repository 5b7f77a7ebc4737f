// SPDX-License-Identifier: Apache-2.0
// PersonPlacer: places sensors with too little overlap from a person who recently walked through
// their views. Input: sightings of heads; output: poses of lost sensors. No I/O. Single-threaded.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "roomcast/alignment/person/trajectory_match.h"
#include "roomcast/alignment/service/placement.h"
#include "roomcast/alignment/view/planes.h"
#include "roomcast/core/clock.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::alignment {

/// How long sightings are kept: the longest walk.
inline constexpr std::chrono::seconds kWalkRemembered{30};

class PersonPlacer {
 public:
  /// Sets the floor of a sensor at a new position; earlier sightings are discarded. A sensor
  /// without a floor is not used.
  void set_floor(const std::string& sensor, const std::optional<alignment::Plane>& floor);
  void forget(const std::string& sensor) { sensors_.erase(sensor); }

  void see(const std::string& sensor, const wire::pb::Sightings& sightings);

  /// Poses of those `lost` sensors that can be placed relative to the `placed`. If `placed` is
  /// empty, the first seed from which another sensor can be placed defines the world. Each pose is
  /// refined by `refine` before the next sensor is placed. For the other lost sensors, the reason
  /// for the failure once there is one.
  [[nodiscard]] std::vector<Placement> place(const KnownPoses& placed,
                                             const std::set<std::string>& lost, const Seeds& seeds,
                                             const RefinePlacement& refine) const;

 private:
  struct Head {
    RoomTime time;
    Eigen::Vector3d seen_m;  // depth frame
  };
  struct Watcher {
    RigidTransform level_from_depth;
    std::deque<Head> heads;  // sorted by time
  };

  [[nodiscard]] std::vector<Placement> place_relative_to(KnownPoses known,
                                                         const std::set<std::string>& lost,
                                                         const RefinePlacement& refine) const;
  [[nodiscard]] std::vector<alignment::HeadSighting> seen_in_world(const KnownPoses& placed) const;
  [[nodiscard]] static std::vector<alignment::HeadSighting> sightings_of(
      const Watcher& watcher, const RigidTransform& pose);
  [[nodiscard]] const Watcher* watcher_of(const std::string& sensor) const;

  std::map<std::string, Watcher> sensors_;
};

}  // namespace roomcast::alignment
