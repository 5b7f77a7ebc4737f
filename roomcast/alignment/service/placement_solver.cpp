// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/service/placement_solver.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "roomcast/alignment/person/head_detector.h"
#include "roomcast/alignment/prior/nudged_pose.h"
#include "roomcast/alignment/prior/refined_placement.h"
#include "roomcast/alignment/prior/stored_pose_check.h"
#include "roomcast/alignment/service/expected_error.h"

namespace roomcast::alignment {
namespace {

std::string not_there(const Error& why) {
  return "The proposed pose was refused: " + why.message;
}

void append_note(std::string& note, const std::string& more) {
  if (!more.empty()) note += (note.empty() ? "" : " ") + more;
}

KnownPoses without(KnownPoses poses, const std::string& sensor) {
  poses.erase(sensor);
  return poses;
}

/// The roster with the results of verification: confirmed poses are estimated ones, contradicted
/// ones are left out.
KnownRoom with_verified(KnownRoom room, const std::map<std::string, Placement>& verified) {
  for (const auto& [sensor, placement] : verified) {
    if (placement.pose.is_placed()) {
      room[sensor].pose = placement.pose;
    } else {
      room.erase(sensor);
    }
  }
  return room;
}

/// The placements, where those of sensors that overlap did not place are replaced by the results of
/// verification.
std::vector<Placement> with_verified(std::vector<Placement> placements,
                                     const std::map<std::string, Placement>& verified) {
  for (Placement& placement : placements) {
    const auto found = verified.find(placement.sensor);
    if (!placement.pose.is_placed() && found != verified.end()) placement = found->second;
  }
  return placements;
}

}  // namespace

void PlacementSolver::add(const alignment::CalibrationBundle& bundle) {
  const auto before = bundles_.find(bundle.name);
  const bool is_rescaled = before != bundles_.end() && bundle.depth_scale &&
                           before->second.depth_scale != bundle.depth_scale &&
                           before->second.calibration.depth == bundle.calibration.depth;
  if (is_rescaled) {
    walks_.forget(bundle.name);
    boards_.forget(bundle.name);
  } else {
    forget(bundle.name);  // it may have been moved
  }
  set_view(bundle);
}

void PlacementSolver::set_view(alignment::CalibrationBundle bundle) {
  bundle.instants.clear();
  if (used_moments_ > 0)
    bundle.instants = instants_.of(bundle.name, bundle.depth_scale.value_or(1));
  auto view = alignment::make_sensor_view(bundle);
  if (!view) return refuse(bundle.name, view.error().message);
  pose_checks_.clear();
  report_.reset();
  refused_.erase(bundle.name);
  walks_.set_floor(bundle.name, view->floor);
  views_[bundle.name] = std::make_shared<const alignment::SensorView>(*std::move(view));
  aligner_.add(views_[bundle.name]);
  bundles_[bundle.name] = std::move(bundle);
}

void PlacementSolver::refuse(const std::string& sensor, const std::string& reason) {
  forget(sensor);
  refused_[sensor] = reason;
}

void PlacementSolver::forget(const std::string& sensor) {
  aligner_.remove(sensor);
  pose_checks_.clear();
  report_.reset();
  views_.erase(sensor);
  bundles_.erase(sensor);
  refused_.erase(sensor);
  walks_.forget(sensor);
  boards_.forget(sensor);
  pending_priors_.erase(sensor);
  accepted_priors_.erase(sensor);
  instants_.forget(sensor);
  used_moments_ = 0;
}

void PlacementSolver::see(const std::string& sensor, const wire::pb::Sightings& sightings) {
  walks_.see(sensor, sightings);
  boards_.see(sensor, sightings);
}

void PlacementSolver::nudge(const std::string& sensor, const RigidTransform& world_from_depth) {
  pending_priors_[sensor] = world_from_depth;
}

/// A single stored pose defines the world only if overlap places nobody without it.
std::vector<Placement> PlacementSolver::solve(const KnownRoom& roster) {
  take_instants();
  if (!report_) {
    const bool all_take_scales = std::ranges::all_of(
        bundles_, [](const auto& bundle) { return bundle.second.depth_scale.has_value(); });
    aligner_.set_scaling(all_take_scales ? DepthScaling::kEstimated : DepthScaling::kAsCalibrated);
    report_ = aligner_.solve();
    for (alignment::SensorReport& sensor : report_->sensors)
      sensor.depth_scale *= bundles_.at(sensor.id).depth_scale.value_or(1);
  }
  Solution solution =
      verify_stored(place_by_overlap(start(roster), roster, LoneStoredPose::kDoubted));
  if (!solution.is_anybody_placed()) {
    const KnownRoom room = with_verified(roster, solution.verified);
    solution = verify_stored(place_by_overlap(std::move(solution), room, LoneStoredPose::kTrusted));
  }
  solution.placements = with_verified(std::move(solution.placements), solution.verified);
  solution = withdraw_what_motion_contradicts(std::move(solution), roster);
  solution = answer_priors(std::move(solution), roster);
  solution = place_by_sightings(std::move(solution), roster);
  set_depth_scales(solution);
  unplaced_ = solution.unplaced();
  return std::move(solution.placements);
}

Placement* PlacementSolver::Solution::placement_of(const std::string& sensor) {
  const auto placement = std::ranges::find(placements, sensor, &Placement::sensor);
  return placement == placements.end() ? nullptr : &*placement;
}

bool PlacementSolver::Solution::is_anybody_placed() const {
  return std::ranges::any_of(placements, [](const Placement& one) { return one.pose.is_placed(); });
}

std::set<std::string> PlacementSolver::Solution::unplaced() const {
  std::set<std::string> names;
  for (const Placement& placement : placements) {
    if (!placement.pose.is_placed() && !valid.contains(placement.sensor))
      names.insert(placement.sensor);
  }
  return names;
}

void PlacementSolver::Solution::place(const Placement& found) {
  valid[found.sensor] = found.pose.world_from_depth;
  unverified.erase(found.sensor);
  if (Placement* placement = placement_of(found.sensor)) *placement = found;
}

PlacementSolver::Solution PlacementSolver::start(const KnownRoom& roster) const {
  Solution solution;
  solution.valid = world_.estimated_in_world(roster);
  for (const auto& [sensor, pose] : given_poses(roster)) solution.valid[sensor] = pose;
  solution.unverified = stored_poses(roster);
  return solution;
}

PlacementSolver::Solution PlacementSolver::place_by_overlap(Solution solution,
                                                            const KnownRoom& room,
                                                            LoneStoredPose lone) {
  solution.placements = world_.place(*report_, room, lone);
  for (const auto& [sensor, reason] : refused_)
    solution.placements.push_back(not_placed(sensor, reason));
  for (const Placement& placement : solution.placements) {
    if (placement.withdrawn) solution.valid.erase(placement.sensor);
    if (!placement.pose.is_placed()) continue;
    solution.valid[placement.sensor] = placement.pose.world_from_depth;
    solution.unverified.erase(placement.sensor);
  }
  for (const auto& [sensor, pose] : given_poses(room)) solution.valid[sensor] = pose;
  return solution;
}

/// Of poses that do not come from the comparison of all sensors: the bundles' own.
void PlacementSolver::set_depth_scales(Solution& solution) const {
  for (Placement& placement : solution.placements) {
    const auto bundle = bundles_.find(placement.sensor);
    if (placement.pose.depth_scale == kOfBundle)
      placement.pose.depth_scale =
          bundle == bundles_.end() ? 1 : bundle->second.depth_scale.value_or(1);
  }
}

/// Verifies the stored poses of sensors that have sent a bundle.
PlacementSolver::Solution PlacementSolver::verify_stored(Solution solution) {
  KnownPoses stored = solution.unverified;
  std::erase_if(stored, [this](const auto& pose) { return !views_.contains(pose.first); });
  const StoredPoseChecks checks = verify_stored_poses(
      stored, solution.valid,
      [this](const NamedPose& a, const NamedPose& b) { return check_pair(a, b); });
  for (const auto& [sensor, placement] : checks.confirmed) {
    solution.valid[sensor] = placement.pose.world_from_depth;
    solution.unverified.erase(sensor);
    solution.verified[sensor] = placement;
  }
  for (const auto& [sensor, placement] : checks.contradicted) {
    solution.unverified.erase(sensor);
    solution.verified[sensor] = placement;
  }
  return solution;
}

/// Cached: every solve() asks again, and the result changes only with a bundle or a pose.
alignment::StoredPoseCheck PlacementSolver::check_pair(const NamedPose& a, const NamedPose& b) {
  const alignment::PairCandidates* pair = aligner_.pair(a.sensor, b.sensor);
  if (pair == nullptr) return {};
  if (pair->a().name != a.sensor) return check_pair(b, a);
  CachedPoseCheck& cached = pose_checks_[{a.sensor, b.sensor}];
  const auto poses = std::array{row_major_from_transform(a.world_from_depth),
                                row_major_from_transform(b.world_from_depth)};
  if (cached.pair != pair || cached.poses != poses) {
    cached = {pair, poses,
              alignment::stored_pose_check(*pair, a.world_from_depth, b.world_from_depth)};
  }
  return cached.result;
}

/// An accepted prior is valid until the sensor sends another bundle.
PlacementSolver::Solution PlacementSolver::answer_priors(Solution solution,
                                                         const KnownRoom& roster) {
  for (const auto& [sensor, placement] : accepted_priors_) solution.place(placement);
  for (const auto& [sensor, prior] : std::exchange(pending_priors_, {})) {
    if (!views_.contains(sensor)) continue;
    KnownPoses placed = without(solution.valid, sensor);
    if (placed.empty()) placed = without(solution.unverified, sensor);
    if (!placed.empty()) {
      const auto answer = prior_near_placed(sensor, prior, placed);
      if (answer) {
        solution.place(accepted_priors_[sensor] = *answer);
      } else if (!accepted_priors_.contains(sensor)) {
        solution.placement_of(sensor)->pose.note = not_there(answer.error());
      }
    } else if (const auto answer = prior_near_unplaced(sensor, prior, placeholder_poses(roster))) {
      const auto& [partner, found] = *answer;
      solution.place(partner);
      solution.place(accepted_priors_[sensor] = found);
    } else {
      solution.placement_of(sensor)->pose.note = not_there(answer.error());
    }
  }
  return solution;
}

Result<Placement> PlacementSolver::prior_near_placed(const std::string& sensor,
                                                     const RigidTransform& prior,
                                                     const KnownPoses& placed) const {
  const auto found =
      alignment::refined_prior(*views_.at(sensor), prior, views_except(sensor, placed));
  if (!found) return found.error();
  return placed_at(sensor, found->world_from_depth, found->expected_error_mm);
}

/// Places a sensor by its prior relative to an unplaced sensor at the placeholder pose that the
/// room shows for it. The other sensor, which is returned first, then defines the world.
Result<std::array<Placement, 2>> PlacementSolver::prior_near_unplaced(
    const std::string& sensor, const RigidTransform& prior, const KnownPoses& placeholders) const {
  std::vector<alignment::PlacedView> others = views_except(sensor, placeholders);
  std::erase_if(others, [](const alignment::PlacedView& other) { return !other.view->floor; });
  const auto found = alignment::refined_prior(*views_.at(sensor), prior, others);
  if (!found) return found.error();
  const RigidTransform level = alignment::level_from_depth(*views_.at(found->beside)->floor);
  const RigidTransform level_from_shown = level * placeholders.at(found->beside).inverse();
  return std::array{
      placed_at(found->beside, level, 0),
      placed_at(sensor, level_from_shown * found->world_from_depth, found->expected_error_mm)};
}

/// Sensors with an unverified pose, then sensors that see a floor.
Seeds PlacementSolver::seeds(const Solution& solution) const {
  const std::set<std::string> unplaced = solution.unplaced();
  Seeds seeds;
  for (const auto& [sensor, pose] : solution.unverified) {
    if (unplaced.contains(sensor)) seeds.emplace_back(sensor, pose);
  }
  for (const std::string& sensor : unplaced) {
    const auto view = views_.find(sensor);
    if (view == views_.end() || !view->second->floor) continue;
    if (!solution.unverified.contains(sensor))
      seeds.emplace_back(sensor, alignment::level_from_depth(*view->second->floor));
  }
  return seeds;
}

/// Sensors that are placed serve to place further ones, until none is left or none is added.
PlacementSolver::Solution PlacementSolver::place_by_sightings(Solution solution,
                                                              const KnownRoom& roster) const {
  std::map<std::string, std::string> notes;
  const auto take = [&](const std::vector<Placement>& found) {
    for (Placement one : found) {
      if (!one.pose.is_placed()) {
        append_note(notes[one.sensor], one.pose.note);
        continue;
      }
      const auto stored = solution.unverified.find(one.sensor);
      if (stored != solution.unverified.end() &&
          is_same_place(stored->second, one.pose.world_from_depth, one.pose.expected_error_mm)) {
        one.pose.world_from_depth = stored->second;
      }
      solution.place(one);
    }
  };
  const auto base = [&] {
    return has_connected(solution.valid, roster) ? solution.valid : KnownPoses();
  };
  const auto refine = [this](Placement found, const KnownPoses& placed) {
    return refined(std::move(found), placed);
  };
  std::set<std::string> unplaced = solution.unplaced();
  for (std::size_t before = unplaced.size() + 1; !unplaced.empty() && unplaced.size() < before;) {
    before = unplaced.size();
    notes.clear();
    take(boards_.place(base(), unplaced, seeds(solution)));
    take(walks_.place(base(), solution.unplaced(), seeds(solution), refine));
    unplaced = solution.unplaced();
  }
  for (const std::string& sensor : unplaced)
    append_note(solution.placement_of(sensor)->pose.note, notes[sensor]);
  return solution;
}

Placement PlacementSolver::refined(Placement found, const KnownPoses& placed) const {
  const auto view = views_.find(found.sensor);
  if (view == views_.end()) return found;
  const auto better = alignment::refined_placement(
      *view->second, {found.pose.world_from_depth, found.pose.expected_error_mm},
      views_except(found.sensor, placed));
  if (!better) return found;
  return placed_at(found.sensor, better->world_from_depth, better->expected_error_mm);
}

std::vector<alignment::PlacedView> PlacementSolver::views_except(const std::string& sensor,
                                                                 const KnownPoses& placed) const {
  std::vector<alignment::PlacedView> others;
  for (const auto& [name, pose] : placed) {
    const auto other = views_.find(name);
    if (other != views_.end() && name != sensor) others.push_back({other->second.get(), pose});
  }
  return others;
}

}  // namespace roomcast::alignment
