// SPDX-License-Identifier: Apache-2.0
// PlacementSolver: estimates the poses of the sensors of a running room from all data so far:
// bundles, and for sensors with too little overlap, sightings of a walking person, sightings of a
// board, and priors that people supply (nudges). The world frame stays fixed (room_world.h).
// Deterministic. Single-threaded.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "roomcast/alignment/prior/prior_evidence.h"
#include "roomcast/alignment/rig/rig_aligner.h"
#include "roomcast/alignment/service/board_placer.h"
#include "roomcast/alignment/service/person_placer.h"
#include "roomcast/alignment/service/placement.h"
#include "roomcast/alignment/service/pose_verification.h"
#include "roomcast/alignment/service/room_world.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::alignment {

class PlacementSolver {
 public:
  /// Adds a bundle; it replaces an earlier one of the same name. An unusable bundle is reported
  /// with the reason, and earlier data of the sensor is discarded.
  void add(const alignment::CalibrationBundle& bundle);
  void refuse(const std::string& sensor, const std::string& reason);
  /// Discards all data of the sensor.
  void forget(const std::string& sensor);

  /// Adds sightings of a sensor.
  void see(const std::string& sensor, const wire::pb::Sightings& sightings);
  /// Adds a person's prior for a pose; the next solve() answers it.
  void nudge(const std::string& sensor, const RigidTransform& world_from_depth);

  /// Placements of all sensors that have been added. Remembered poses are compared with the current
  /// views: confirmed ones are returned as estimated, contradicted ones are withdrawn. If the
  /// comparison is inconclusive, the sensor is lost and meanwhile keeps its remembered pose in the
  /// roster.
  [[nodiscard]] std::vector<Placement> solve(KnownRoom known);

  /// After the last solve(): some sensors have no pose and could be placed by sightings.
  [[nodiscard]] bool wants_sightings() const { return !unplaced_.empty() && views_.size() > 1; }

 private:
  /// The working state of one solve().
  struct Room {
    KnownRoom told;                     // `remembered` shrinks to the poses that are not verified
    std::vector<Placement> placements;  // the result
    KnownPoses known;                   // valid poses, to place others by

    [[nodiscard]] Placement* placement_of(const std::string& sensor);
    void place(const Placement& found);
    /// The known poses; empty if all sensors with a known pose are away.
    [[nodiscard]] KnownPoses base() const;
  };

  /// The result of stored_pose_check for a pair of sensors at these poses.
  struct CachedPoseCheck {
    const alignment::PairCandidates* pair = nullptr;
    std::array<std::array<double, 16>, 2> poses{};
    alignment::StoredPoseCheck told;
  };

  void recall(Room& room, std::map<std::string, Placement>& recalled);
  [[nodiscard]] alignment::StoredPoseCheck witness(const NamedPose& a, const NamedPose& b);
  void place_by_overlap(Room& room, LoneStoredPose lone);
  void place_by_nudge(Room& room);
  void keep_nudged(const Placement& found, Room& room);
  void try_prior_near_unplaced(const std::string& sensor, const RigidTransform& guess, Room& room);
  void place_unplaced(Room& room);
  [[nodiscard]] Seeds seeds(const Room& room) const;
  void settle(Placement& found, const KnownPoses& placed) const;
  /// The views of the placed sensors, except this one.
  [[nodiscard]] std::vector<alignment::PlacedView> views_except(const std::string& sensor,
                                                                const KnownPoses& placed) const;

  alignment::RigAligner aligner_;
  std::optional<alignment::AlignmentReport> report_;  // valid until a bundle is added or removed
  std::map<std::string, std::shared_ptr<const alignment::SensorView>> views_;
  std::map<std::string, std::string> refused_;  // reasons
  std::set<std::string> unplaced_;
  std::map<std::pair<std::string, std::string>, CachedPoseCheck> pose_checks_;
  RoomWorld world_;
  PersonPlacer walks_;
  BoardPlacer boards_;
  KnownPoses pending_priors_;                         // priors that are not answered yet
  std::map<std::string, Placement> accepted_priors_;  // priors that were accepted
};

}  // namespace roomcast::alignment
