// SPDX-License-Identifier: Apache-2.0
#include "roomcast/aligner/room_placing.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "roomcast/align/guess/nudged_pose.h"
#include "roomcast/align/guess/settled_place.h"

namespace roomcast::aligner {

void RoomPlacing::add(const align::CalibrationBundle& bundle) {
  auto view = align::make_sensor_view(bundle);
  if (!view) return refuse(bundle.name, view.error().message);
  forget(bundle.name);
  walks_.stand(bundle.name, view->floor);
  views_[bundle.name] = std::make_shared<const align::SensorView>(*std::move(view));
  aligner_.add(views_[bundle.name]);
}

void RoomPlacing::refuse(const std::string& sensor, const std::string& reason) {
  forget(sensor);
  refused_[sensor] = reason;
}

void RoomPlacing::forget(const std::string& sensor) {
  aligner_.remove(sensor);
  report_.reset();
  views_.erase(sensor);
  refused_.erase(sensor);
  walks_.forget(sensor);
  boards_.forget(sensor);
  guesses_.erase(sensor);
  by_hand_.erase(sensor);
}

void RoomPlacing::see(const std::string& sensor, const wire::pb::Sightings& sightings) {
  walks_.see(sensor, sightings);
  boards_.see(sensor, sightings);
}

void RoomPlacing::nudge(const std::string& sensor, const RigidTransform& world_from_depth) {
  guesses_[sensor] = world_from_depth;
}

std::vector<Placement> RoomPlacing::solve(const KnownPoses& given, const KnownPoses& found_before) {
  if (!report_) report_ = aligner_.solve();
  auto placements = world_.place(*report_, given, found_before);
  for (const auto& [sensor, reason] : refused_) {
    Placement& placement = placements.emplace_back();
    placement.sensor = sensor;
    placement.note = reason;
  }
  KnownPoses known = world_.settled(given, found_before);
  for (const Placement& placement : placements) {
    if (placement.world_from_depth) known[placement.sensor] = *placement.world_from_depth;
  }
  for (const auto& [sensor, pose] : given) known[sensor] = pose;
  place_by_hand(placements, known);
  place_the_lost(placements, known);
  return placements;
}

/// A guess that was accepted holds until the sensor sees something else.
void RoomPlacing::place_by_hand(std::vector<Placement>& placements, const KnownPoses& known) {
  for (Placement& placement : placements) {
    const auto guess = guesses_.find(placement.sensor);
    const auto view = views_.find(placement.sensor);
    if (guess != guesses_.end() && view != views_.end()) {
      const auto answer =
          align::refined_guess(*view->second, guess->second, views_beside(placement.sensor, known));
      if (!answer) {
        placement.note = "Not where it was put: " + answer.error().message;
      } else {
        Placement& held = by_hand_[placement.sensor];
        held = placement;
        held.world_from_depth = answer->world_from_depth;
        held.expected_error_mm = answer->expected_error_mm;
        held.note.clear();
      }
    }
    if (const auto held = by_hand_.find(placement.sensor); held != by_hand_.end())
      placement = held->second;
  }
  guesses_.clear();
}

void RoomPlacing::place_the_lost(std::vector<Placement>& placements, const KnownPoses& known) {
  lost_.clear();
  for (const Placement& placement : placements) {
    if (!placement.world_from_depth && !known.contains(placement.sensor))
      lost_.insert(placement.sensor);
  }
  if (lost_.empty()) return;
  const auto take = [&](const std::vector<Placement>& found) {
    for (const Placement& one : found) {
      const auto placement = std::ranges::find(placements, one.sensor, &Placement::sensor);
      if (placement == placements.end() || placement->world_from_depth) continue;
      placement->world_from_depth = one.world_from_depth;
      placement->expected_error_mm = one.expected_error_mm;
      if (one.world_from_depth) {
        placement->note.clear();
        lost_.erase(one.sensor);
      } else if (!one.note.empty()) {
        placement->note += (placement->note.empty() ? "" : " ") + one.note;
      }
    }
  };
  take(boards_.place(known, lost_));
  take(walks_.place(known, lost_,
                    [this](Placement& found, const KnownPoses& placed) { settle(found, placed); }));
}

void RoomPlacing::settle(Placement& found, const KnownPoses& placed) const {
  const auto view = views_.find(found.sensor);
  if (view == views_.end()) return;
  const auto settled =
      align::settled_place(*view->second, {*found.world_from_depth, found.expected_error_mm},
                           views_beside(found.sensor, placed));
  if (!settled) return;
  found.world_from_depth = settled->world_from_depth;
  found.expected_error_mm = settled->expected_error_mm;
}

std::vector<align::PlacedView> RoomPlacing::views_beside(const std::string& sensor,
                                                         const KnownPoses& placed) const {
  std::vector<align::PlacedView> others;
  for (const auto& [name, pose] : placed) {
    const auto other = views_.find(name);
    if (other != views_.end() && name != sensor) others.push_back({other->second.get(), pose});
  }
  return others;
}

}  // namespace roomcast::aligner
