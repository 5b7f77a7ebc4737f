// SPDX-License-Identifier: Apache-2.0
// How a PlacementSolver uses what moves: it compares all sensors again when enough has moved, and
// withdraws poses that this contradicts.
#include <algorithm>
#include <utility>

#include "roomcast/alignment/prior/prior_evidence.h"
#include "roomcast/alignment/service/placement_solver.h"

namespace roomcast::alignment {
namespace {

/// Moments at which two sensors see something move, to begin with; a factor on readings takes five.
constexpr std::size_t kMinSharedMoments = 8;
/// Moments after which no more are asked for while all sensors have a pose.
constexpr std::size_t kEnoughMoments = 64;
/// Belief that sensors are not calibrated above which their factors are sought.
constexpr double kDoubtsCalibration = 0.6;

}  // namespace

void PlacementSolver::see(const std::string& sensor, DepthInstant instant, double depth_scale) {
  const auto bundle = bundles_.find(sensor);
  if (bundle == bundles_.end()) return;
  // A sensor that has come back with another camera has not sent its bundle yet.
  const CameraIntrinsics& camera = bundle->second.calibration.depth;
  const bool is_of_bundle = instant.depth_mm.width() == camera.width / kInstantBlock &&
                            instant.depth_mm.height() == camera.height / kInstantBlock;
  if (is_of_bundle) instants_.add(sensor, std::move(instant), depth_scale);
}

bool PlacementSolver::wants_instants() const {
  const auto takes_part = [](const auto& bundle) { return bundle.second.depth_scale.has_value(); };
  if (std::ranges::count_if(bundles_, takes_part) < 2) return false;
  if (!unplaced_.empty()) return true;
  if (!report_ || used_moments_ >= kEnoughMoments) return false;
  const bool is_confirmed = std::ranges::all_of(report_->sensors, &alignment::SensorReport::placed);
  if (!is_confirmed) return true;  // some keep an earlier pose, which motion may contradict
  if (report_->uncalibrated_belief < kDoubtsCalibration) return false;
  // Factors are relative to the origin's, so one of the placed sensors has none.
  return std::ranges::count_if(report_->sensors, [](const alignment::SensorReport& sensor) {
           return sensor.placed && sensor.depth_scale_standard_error == 0;
         }) > 1;
}

bool PlacementSolver::has_new_instants() {
  return wants_instants() &&
         instants_.shared_moments() >= std::max(kMinSharedMoments, 2 * used_moments_);
}

void PlacementSolver::take_instants() {
  if (!has_new_instants()) return;
  used_moments_ = instants_.shared_moments();
  const auto bundles = bundles_;
  for (const auto& [sensor, bundle] : bundles) set_view(bundle);
}

/// Withdraws estimated poses at which what moves is not where another sensor sees it.
PlacementSolver::Solution PlacementSolver::withdraw_what_motion_contradicts(
    Solution solution, const KnownRoom& roster) const {
  KnownPoses sure = given_poses(roster);
  for (const Placement& placement : solution.placements) {
    if (placement.pose.is_placed()) sure[placement.sensor] = placement.pose.world_from_depth;
  }
  for (const auto& [sensor, pose] : estimated_poses(roster)) {
    Placement* const placement = solution.placement_of(sensor);
    const bool is_kept = placement != nullptr && !placement->pose.is_placed() &&
                         !placement->withdrawn && solution.valid.contains(sensor);
    if (!is_kept) continue;
    const auto against =
        std::ranges::find_if(sure, [&, &sensor = sensor, &pose = pose](const auto& other) {
          return other.first != sensor &&
                 is_refuted_by_motion({sensor, pose}, {other.first, other.second});
        });
    if (against == sure.end()) {
      sure[sensor] = pose;
      continue;
    }
    *placement = not_placed(
        sensor, "Its pose was wrong: what moves was not where " + against->first + " sees it.");
    placement->withdrawn = true;
    solution.valid.erase(sensor);
  }
  return solution;
}

bool PlacementSolver::is_refuted_by_motion(const NamedPose& a, const NamedPose& b) const {
  const alignment::PairCandidates* pair = aligner_.pair(a.sensor, b.sensor);
  if (pair == nullptr || used_moments_ == 0) return false;
  if (pair->a().name != a.sensor) return is_refuted_by_motion(b, a);
  const auto evidence = pair->examine(a.world_from_depth.inverse() * b.world_from_depth);
  return alignment::contradiction(evidence) == alignment::Contradiction::kMovement;
}

}  // namespace roomcast::alignment
