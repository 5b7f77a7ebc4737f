// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/service/person_placer.h"

#include <algorithm>

#include "roomcast/alignment/person/head_detector.h"
#include "roomcast/alignment/service/seeded_world.h"

namespace roomcast::alignment {
namespace {

constexpr std::size_t kMaxHeadsKept = 2000;

RoomTime room_time(std::uint64_t ns) {
  return RoomTime(nanoseconds(static_cast<std::int64_t>(ns)));
}

}  // namespace

void PersonPlacer::set_floor(const std::string& sensor,
                             const std::optional<alignment::Plane>& floor) {
  forget(sensor);
  if (floor) sensors_[sensor].level_from_depth = alignment::level_from_depth(*floor);
}

void PersonPlacer::see(const std::string& sensor, const wire::pb::Sightings& sightings) {
  const auto found = sensors_.find(sensor);
  if (found == sensors_.end()) return;
  auto& heads = found->second.heads;
  for (const auto& head : sightings.heads()) {
    const RoomTime time = room_time(head.room_ns());
    if (!heads.empty() && time < heads.back().time) continue;
    heads.push_back({time, Eigen::Vector3d(head.x(), head.y(), head.z())});
  }
  while (!heads.empty() && (heads.back().time - heads.front().time > kWalkRemembered ||
                            heads.size() > kMaxHeadsKept)) {
    heads.pop_front();
  }
}

const PersonPlacer::Watcher* PersonPlacer::watcher_of(const std::string& sensor) const {
  const auto found = sensors_.find(sensor);
  return found != sensors_.end() && !found->second.heads.empty() ? &found->second : nullptr;
}

std::vector<alignment::HeadSighting> PersonPlacer::sightings_of(const Watcher& watcher,
                                                                const RigidTransform& pose) {
  std::vector<alignment::HeadSighting> sightings;
  sightings.reserve(watcher.heads.size());
  for (const Head& head : watcher.heads) {
    const double time_s = std::chrono::duration<double>(head.time.time_since_epoch()).count();
    sightings.push_back(alignment::head_sighting(pose, time_s, head.seen_m));
  }
  return sightings;
}

std::vector<alignment::HeadSighting> PersonPlacer::seen_in_world(const KnownPoses& placed) const {
  std::vector<alignment::HeadSighting> all;
  for (const auto& [sensor, world_from_depth] : placed) {
    const Watcher* watcher = watcher_of(sensor);
    if (watcher == nullptr) continue;
    const auto seen = sightings_of(*watcher, world_from_depth);
    all.insert(all.end(), seen.begin(), seen.end());
  }
  std::ranges::stable_sort(all, {}, &alignment::HeadSighting::time_s);
  return all;
}

std::vector<Placement> PersonPlacer::place_relative_to(KnownPoses known,
                                                       const std::set<std::string>& lost,
                                                       const RefinePlacement& refine) const {
  std::vector<Placement> placements;
  for (const std::string& sensor : lost) {
    const Watcher* watcher = watcher_of(sensor);
    if (watcher == nullptr) continue;
    const auto match = alignment::match_walks(seen_in_world(known),
                                              sightings_of(*watcher, watcher->level_from_depth));
    if (!match) {
      placements.push_back(not_placed(sensor, match.error().message));
      continue;
    }
    placements.push_back(refine(
        placed_at(sensor, match->a_from_b * watcher->level_from_depth, match->expected_error_mm),
        known));
    known[sensor] = placements.back().pose.world_from_depth;
  }
  return placements;
}

std::vector<Placement> PersonPlacer::place(const KnownPoses& placed,
                                           const std::set<std::string>& lost, const Seeds& seeds,
                                           const RefinePlacement& refine) const {
  return place_or_seed(placed, lost, seeds, [&](const auto& known, const auto& others) {
    return place_relative_to(known, others, refine);
  });
}

}  // namespace roomcast::alignment
