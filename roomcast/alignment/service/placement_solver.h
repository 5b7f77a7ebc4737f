// SPDX-License-Identifier: Apache-2.0
// PlacementSolver: estimates the poses of the sensors of a running room from all data so far:
// bundles, instants in which something moves, and for sensors with too little overlap, sightings of
// a walking person, sightings of a board, and priors that people supply (nudges). The world frame
// stays fixed (room_world.h).
// Deterministic. Single-threaded.
#pragma once

#include <array>
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
#include "roomcast/alignment/service/instant_store.h"
#include "roomcast/alignment/service/person_placer.h"
#include "roomcast/alignment/service/placement.h"
#include "roomcast/alignment/service/pose_verification.h"
#include "roomcast/alignment/service/room_world.h"
#include "roomcast/core/result.h"
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
  /// Adds what a sensor saw at an instant, with readings multiplied by `depth_scale`.
  void see(const std::string& sensor, DepthInstant instant, double depth_scale);
  /// Adds a person's prior for a pose; the next solve() answers it.
  void nudge(const std::string& sensor, const RigidTransform& world_from_depth);

  /// Placements of all sensors that have been added. Stored poses are compared with the current
  /// views: confirmed ones are returned as estimated, contradicted ones are withdrawn. If the
  /// comparison is inconclusive, the sensor is unplaced and meanwhile keeps its stored pose in the
  /// roster.
  [[nodiscard]] std::vector<Placement> solve(const KnownRoom& roster);

  /// After the last solve(): some sensors have no pose and could be placed by sightings.
  [[nodiscard]] bool wants_sightings() const { return !unplaced_.empty() && views_.size() > 1; }
  /// After the last solve(): instants could place a sensor, or tell how calibrated sensors are.
  [[nodiscard]] bool wants_instants() const;
  /// Whether enough instants were seen since the last solve() to compare all sensors again.
  [[nodiscard]] bool has_new_instants();

 private:
  /// What the steps of one solve() have found so far. Each step takes one and returns the next.
  struct Solution {
    std::vector<Placement> placements;
    KnownPoses valid;       // of all sensors: poses to place others by
    KnownPoses unverified;  // stored poses that nothing has confirmed or contradicted
    std::map<std::string, Placement> verified;  // confirmed and contradicted stored poses

    [[nodiscard]] Placement* placement_of(const std::string& sensor);
    [[nodiscard]] bool is_anybody_placed() const;
    /// Names of the sensors without a pose.
    [[nodiscard]] std::set<std::string> unplaced() const;
    void place(const Placement& found);
  };

  /// The result of stored_pose_check for a pair of sensors at these poses.
  struct CachedPoseCheck {
    const alignment::PairCandidates* pair = nullptr;
    std::array<std::array<double, 16>, 2> poses{};
    alignment::StoredPoseCheck result;
  };

  /// Derives the sensor's view from its bundle, and from its instants if they are used.
  void set_view(alignment::CalibrationBundle bundle);
  /// Compares all sensors again, also by what moves, if enough has moved.
  void take_instants();
  /// Sets the factors on readings that poses assume.
  void set_depth_scales(Solution& solution) const;
  [[nodiscard]] Solution withdraw_what_motion_contradicts(Solution solution,
                                                          const KnownRoom& roster) const;
  [[nodiscard]] bool is_refuted_by_motion(const NamedPose& a, const NamedPose& b) const;

  [[nodiscard]] Solution start(const KnownRoom& roster) const;
  [[nodiscard]] Solution place_by_overlap(Solution solution, const KnownRoom& room,
                                          LoneStoredPose lone);
  [[nodiscard]] Solution verify_stored(Solution solution);
  [[nodiscard]] Solution answer_priors(Solution solution, const KnownRoom& roster);
  [[nodiscard]] Solution place_by_sightings(Solution solution, const KnownRoom& roster) const;

  [[nodiscard]] alignment::StoredPoseCheck check_pair(const NamedPose& a, const NamedPose& b);
  [[nodiscard]] Result<Placement> prior_near_placed(const std::string& sensor,
                                                    const RigidTransform& prior,
                                                    const KnownPoses& placed) const;
  [[nodiscard]] Result<std::array<Placement, 2>> prior_near_unplaced(
      const std::string& sensor, const RigidTransform& prior, const KnownPoses& placeholders) const;
  [[nodiscard]] Seeds seeds(const Solution& solution) const;
  [[nodiscard]] Placement refined(Placement found, const KnownPoses& placed) const;
  /// The views of the placed sensors, except this one.
  [[nodiscard]] std::vector<alignment::PlacedView> views_except(const std::string& sensor,
                                                                const KnownPoses& placed) const;

  alignment::RigAligner aligner_;
  std::optional<alignment::AlignmentReport> report_;  // valid until a bundle is added or removed
  std::map<std::string, std::shared_ptr<const alignment::SensorView>> views_;
  std::map<std::string, alignment::CalibrationBundle> bundles_;  // of the views
  InstantStore instants_;
  std::size_t used_moments_ = 0;                // with shared motion, in the views
  std::map<std::string, std::string> refused_;  // reasons
  std::set<std::string> unplaced_;              // by the last solve()
  std::map<std::pair<std::string, std::string>, CachedPoseCheck> pose_checks_;
  RoomWorld world_;
  PersonPlacer walks_;
  BoardPlacer boards_;
  KnownPoses pending_priors_;                         // priors that are not answered yet
  std::map<std::string, Placement> accepted_priors_;  // priors that were accepted
};

}  // namespace roomcast::alignment
