// SPDX-License-Identifier: Apache-2.0
// PersonPlacer: places sensors that share too little with the others by somebody who walked through
// their views lately. What sensors tell of heads comes in; where a lost sensor stands comes out.
// Pure. Single-threaded.
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

/// A walk may have taken so long.
inline constexpr std::chrono::seconds kWalkRemembered{30};

class PersonPlacer {
 public:
  /// Where a sensor stands has become known, or changed: what it saw before no longer counts.
  /// Without a floor it takes no part.
  void stand(const std::string& sensor, const std::optional<alignment::Plane>& floor);
  void forget(const std::string& sensor) { sensors_.erase(sensor); }

  void see(const std::string& sensor, const wire::pb::Sightings& sightings);

  /// Those of the `lost` that can be placed beside the `placed`. Where nobody is placed yet, the
  /// first of the seeds beside whom another can be makes the world. Each settles before the next is
  /// looked at. For the others the reason, once there is one.
  [[nodiscard]] std::vector<Placement> place(const KnownPoses& placed,
                                             const std::set<std::string>& lost, const Seeds& seeds,
                                             const Settle& settle) const;

 private:
  struct Head {
    RoomTime time;
    Eigen::Vector3d seen_m;  // depth frame
  };
  struct Watcher {
    RigidTransform level_from_depth;
    std::deque<Head> heads;  // in the order of time
  };

  [[nodiscard]] std::vector<Placement> place_beside(KnownPoses known,
                                                    const std::set<std::string>& lost,
                                                    const Settle& settle) const;
  [[nodiscard]] std::vector<alignment::HeadSighting> seen_in_world(const KnownPoses& placed) const;
  [[nodiscard]] static std::vector<alignment::HeadSighting> sightings_of(const Watcher& watcher,
                                                                     const RigidTransform& pose);
  [[nodiscard]] const Watcher* watcher_of(const std::string& sensor) const;

  std::map<std::string, Watcher> sensors_;
};

}  // namespace roomcast::alignment
