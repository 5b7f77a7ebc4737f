// SPDX-License-Identifier: Apache-2.0
// PlacementSolver: where the sensors of a running room stand, from all that has come so far: what
// they see (bundles), and for those that share too little, who walked through their views, a board
// that was held into them, and people's guesses. The world stays where it is (room_world.h).
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
  /// What a sensor sees. One of that name takes the place of an earlier one. One that is of no use
  /// is reported with its reason, and what was known of the sensor is forgotten.
  void add(const alignment::CalibrationBundle& bundle);
  void refuse(const std::string& sensor, const std::string& reason);
  /// What was known of it no longer holds.
  void forget(const std::string& sensor);

  /// What passed through a sensor's view.
  void see(const std::string& sensor, const wire::pb::Sightings& sightings);
  /// A person's guess, answered by the next solve().
  void nudge(const std::string& sensor, const RigidTransform& world_from_depth);

  /// All sensors that have been added. Remembered poses are compared with what is seen there now:
  /// those that hold are found again, those that are contradicted are withdrawn. Where nothing
  /// tells, the sensor is lost, and stays where it was meanwhile.
  [[nodiscard]] std::vector<Placement> solve(KnownRoom known);

  /// After the last solve(): some sensors can be placed by what passes through their views only.
  [[nodiscard]] bool wants_sightings() const { return !unplaced_.empty() && views_.size() > 1; }

 private:
  /// While it solves.
  struct Room {
    KnownRoom told;                     // remembered: those that nothing has confirmed
    std::vector<Placement> placements;  // the answer
    KnownPoses known;                   // who holds, and may be a base for others

    [[nodiscard]] Placement* placement_of(const std::string& sensor);
    void place(const Placement& found);
    /// The known poses; none where all who have one have left.
    [[nodiscard]] KnownPoses base() const;
  };

  /// What two sensors said of where they were thought to stand.
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
  /// What those see that are placed, but for this sensor.
  [[nodiscard]] std::vector<alignment::PlacedView> views_except(const std::string& sensor,
                                                            const KnownPoses& placed) const;

  alignment::RigAligner aligner_;
  std::optional<alignment::AlignmentReport> report_;  // while nothing new was added
  std::map<std::string, std::shared_ptr<const alignment::SensorView>> views_;
  std::map<std::string, std::string> refused_;  // reasons
  std::set<std::string> unplaced_;
  std::map<std::pair<std::string, std::string>, CachedPoseCheck> pose_checks_;
  RoomWorld world_;
  PersonPlacer walks_;
  BoardPlacer boards_;
  KnownPoses guesses_;                        // not answered yet
  std::map<std::string, Placement> by_hand_;  // guesses that were accepted
};

}  // namespace roomcast::alignment
