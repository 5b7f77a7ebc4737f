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

Placement placed_at(const std::string& sensor, const RigidTransform& world_from_depth,
                    double expected_error_mm) {
  Placement placement;
  placement.sensor = sensor;
  placement.world_from_depth = world_from_depth;
  placement.expected_error_mm = expected_error_mm;
  return placement;
}

std::string not_there(const Error& why) {
  return "The proposed pose was refused: " + why.message;
}

}  // namespace

void PlacementSolver::add(const alignment::CalibrationBundle& bundle) {
  auto view = alignment::make_sensor_view(bundle);
  if (!view) return refuse(bundle.name, view.error().message);
  forget(bundle.name);
  walks_.stand(bundle.name, view->floor);
  views_[bundle.name] = std::make_shared<const alignment::SensorView>(*std::move(view));
  aligner_.add(views_[bundle.name]);
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
  refused_.erase(sensor);
  walks_.forget(sensor);
  boards_.forget(sensor);
  pending_priors_.erase(sensor);
  accepted_priors_.erase(sensor);
}

void PlacementSolver::see(const std::string& sensor, const wire::pb::Sightings& sightings) {
  walks_.see(sensor, sightings);
  boards_.see(sensor, sightings);
}

void PlacementSolver::nudge(const std::string& sensor, const RigidTransform& world_from_depth) {
  pending_priors_[sensor] = world_from_depth;
}

std::vector<Placement> PlacementSolver::solve(KnownRoom known) {
  if (!report_) report_ = aligner_.solve();
  Room room{std::move(known), {}, {}};
  room.known = world_.settled(room.told);
  for (const auto& [sensor, pose] : room.told.given) room.known[sensor] = pose;

  std::map<std::string, Placement> recalled;
  place_by_overlap(room, LoneStoredPose::kDoubted);
  const bool is_anybody_placed = std::ranges::any_of(
      room.placements, [](const Placement& one) { return one.world_from_depth.has_value(); });
  recall(room, recalled);
  if (!is_anybody_placed) {
    place_by_overlap(room, LoneStoredPose::kTrusted);
    recall(room, recalled);  // relative to the sensors placed just now
  }
  for (const auto& [sensor, placement] : recalled) {
    Placement* place = room.placement_of(sensor);
    if (place != nullptr && !place->world_from_depth) *place = placement;
  }
  place_by_nudge(room);
  place_unplaced(room);
  return std::move(room.placements);
}

Placement* PlacementSolver::Room::placement_of(const std::string& sensor) {
  const auto placement = std::ranges::find(placements, sensor, &Placement::sensor);
  return placement == placements.end() ? nullptr : &*placement;
}

KnownPoses PlacementSolver::Room::base() const {
  const bool is_anybody_here = std::ranges::any_of(
      known, [this](const auto& pose) { return !told.away.contains(pose.first); });
  return is_anybody_here ? known : KnownPoses();
}

void PlacementSolver::Room::place(const Placement& found) {
  known[found.sensor] = *found.world_from_depth;
  told.remembered.erase(found.sensor);
  if (Placement* placement = placement_of(found.sensor)) *placement = found;
}

/// Verifies the remembered poses of sensors that have sent a bundle.
void PlacementSolver::recall(Room& room, std::map<std::string, Placement>& recalled) {
  KnownPoses here = room.told.remembered;
  std::erase_if(here, [this](const auto& pose) { return !views_.contains(pose.first); });
  const auto told = verify_stored_poses(
      here, room.known, [this](const NamedPose& a, const NamedPose& b) { return witness(a, b); });
  for (const auto& [sensor, placement] : told.confirmed) {
    room.place(placement);
    room.told.found[sensor] = *placement.world_from_depth;
    recalled[sensor] = placement;
  }
  for (const auto& [sensor, placement] : told.contradicted) {
    room.told.remembered.erase(sensor);
    recalled[sensor] = placement;
  }
}

/// Cached: every solve() asks again, and the result changes only with a bundle or a pose.
alignment::StoredPoseCheck PlacementSolver::witness(const NamedPose& a, const NamedPose& b) {
  const alignment::PairCandidates* pair = aligner_.pair(a.sensor, b.sensor);
  if (pair == nullptr) return {};
  if (pair->a().name != a.sensor) return witness(b, a);
  CachedPoseCheck& testimony = pose_checks_[{a.sensor, b.sensor}];
  const auto poses = std::array{row_major_from_transform(a.world_from_depth),
                                row_major_from_transform(b.world_from_depth)};
  if (testimony.pair != pair || testimony.poses != poses) {
    testimony = {pair, poses,
                 alignment::stored_pose_check(*pair, a.world_from_depth, b.world_from_depth)};
  }
  return testimony.told;
}

void PlacementSolver::place_by_overlap(Room& room, LoneStoredPose lone) {
  room.placements = world_.place(*report_, room.told, lone);
  for (const auto& [sensor, reason] : refused_) {
    Placement& placement = room.placements.emplace_back();
    placement.sensor = sensor;
    placement.note = reason;
  }
  for (const Placement& placement : room.placements) {
    if (placement.withdrawn) room.known.erase(placement.sensor);
    if (!placement.world_from_depth) continue;
    room.known[placement.sensor] = *placement.world_from_depth;
    room.told.remembered.erase(placement.sensor);
  }
  for (const auto& [sensor, pose] : room.told.given) room.known[sensor] = pose;
}

/// An accepted prior is valid until the sensor sends another bundle.
void PlacementSolver::place_by_nudge(Room& room) {
  for (const auto& [sensor, placement] : accepted_priors_) room.place(placement);
  for (const auto& [sensor, guess] : pending_priors_) {
    const auto view = views_.find(sensor);
    if (view == views_.end()) continue;
    KnownPoses base = room.known;
    base.erase(sensor);
    if (base.empty()) base = room.told.remembered;
    base.erase(sensor);
    if (base.empty()) {
      try_prior_near_unplaced(sensor, guess, room);
      continue;
    }
    const auto answer = alignment::refined_prior(*view->second, guess, views_except(sensor, base));
    if (answer) {
      keep_nudged(placed_at(sensor, answer->world_from_depth, answer->expected_error_mm), room);
    } else if (!accepted_priors_.contains(sensor)) {
      room.placement_of(sensor)->note = not_there(answer.error());
    }
  }
  pending_priors_.clear();
}

void PlacementSolver::keep_nudged(const Placement& found, Room& room) {
  accepted_priors_[found.sensor] = found;
  room.place(found);
}

/// Places a sensor by its prior relative to an unplaced sensor at the placeholder pose that the
/// room shows for it. The other sensor then defines the world.
void PlacementSolver::try_prior_near_unplaced(const std::string& sensor,
                                              const RigidTransform& guess, Room& room) {
  const alignment::SensorView& view = *views_.at(sensor);
  std::vector<alignment::PlacedView> others = views_except(sensor, room.told.provisional);
  std::erase_if(others, [](const alignment::PlacedView& other) { return !other.view->floor; });
  const auto answer = alignment::refined_prior(view, guess, others);
  if (!answer) {
    room.placement_of(sensor)->note = not_there(answer.error());
    return;
  }
  const RigidTransform level = alignment::level_from_depth(*views_.at(answer->beside)->floor);
  room.place(placed_at(answer->beside, level, 0));
  const RigidTransform level_from_shown =
      level * room.told.provisional.at(answer->beside).inverse();
  keep_nudged(
      placed_at(sensor, level_from_shown * answer->world_from_depth, answer->expected_error_mm),
      room);
}

/// Sensors with a remembered pose, then sensors that see a floor.
Seeds PlacementSolver::seeds(const Room& room) const {
  Seeds seeds;
  for (const auto& [sensor, pose] : room.told.remembered) {
    if (unplaced_.contains(sensor)) seeds.emplace_back(sensor, pose);
  }
  for (const std::string& sensor : unplaced_) {
    const auto view = views_.find(sensor);
    if (view == views_.end() || !view->second->floor) continue;
    if (!room.told.remembered.contains(sensor))
      seeds.emplace_back(sensor, alignment::level_from_depth(*view->second->floor));
  }
  return seeds;
}

void PlacementSolver::place_unplaced(Room& room) {
  unplaced_.clear();
  for (const Placement& placement : room.placements) {
    if (!placement.world_from_depth && !room.known.contains(placement.sensor))
      unplaced_.insert(placement.sensor);
  }
  std::map<std::string, std::string> notes;
  const auto take = [&](std::vector<Placement> found) {
    for (Placement& one : found) {
      if (!one.world_from_depth) {
        std::string& note = notes[one.sensor];
        if (!one.note.empty()) note += (note.empty() ? "" : " ") + one.note;
        continue;
      }
      const auto before = room.told.remembered.find(one.sensor);
      if (before != room.told.remembered.end() &&
          is_same_place(before->second, *one.world_from_depth, one.expected_error_mm)) {
        one.world_from_depth = before->second;
      }
      room.place(one);
      unplaced_.erase(one.sensor);
    }
  };
  const auto settled = [this](Placement& found, const KnownPoses& placed) {
    settle(found, placed);
  };
  for (std::size_t before = unplaced_.size() + 1;
       !unplaced_.empty() && unplaced_.size() < before;) {
    before = unplaced_.size();
    notes.clear();
    take(boards_.place(room.base(), unplaced_, seeds(room)));
    take(walks_.place(room.base(), unplaced_, seeds(room), settled));
  }
  for (const auto& [sensor, note] : notes) {
    if (!unplaced_.contains(sensor) || note.empty()) continue;
    std::string& all = room.placement_of(sensor)->note;
    all += (all.empty() ? "" : " ") + note;
  }
}

void PlacementSolver::settle(Placement& found, const KnownPoses& placed) const {
  const auto view = views_.find(found.sensor);
  if (view == views_.end()) return;
  const auto settled = alignment::refined_placement(
      *view->second, {*found.world_from_depth, found.expected_error_mm},
      views_except(found.sensor, placed));
  if (!settled) return;
  found.world_from_depth = settled->world_from_depth;
  found.expected_error_mm = settled->expected_error_mm;
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
