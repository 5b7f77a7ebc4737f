// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/service/board_placer.h"

#include <optional>
#include <utility>

#include "roomcast/alignment/service/seeded_world.h"

namespace roomcast::alignment {
namespace {

constexpr std::size_t kMaxKept = 2000;

alignment::TagSighting sighting_of(const wire::pb::TagSighting& message) {
  alignment::TagSighting sighting;
  sighting.time_s = 1e-9 * static_cast<double>(static_cast<std::int64_t>(message.room_ns()));
  sighting.tag = static_cast<int>(message.tag());
  for (int i = 0; i < 4; ++i) {
    sighting.corners_m[static_cast<std::size_t>(i)] = {
        message.corners(3 * i), message.corners(3 * i + 1), message.corners(3 * i + 2)};
  }
  return sighting;
}

}  // namespace

void BoardPlacer::see(const std::string& sensor, const wire::pb::Sightings& sightings) {
  if (sightings.tags().empty()) return;
  constexpr double kRemembered_s = std::chrono::duration<double>(kBoardRemembered).count();
  Sightings& seen = seen_[sensor];
  for (const auto& tag : sightings.tags()) {
    const auto sighting = sighting_of(tag);
    if (seen.empty() || sighting.time_s >= seen.back().time_s) seen.push_back(sighting);
  }
  while (!seen.empty() &&
         (seen.back().time_s - seen.front().time_s > kRemembered_s || seen.size() > kMaxKept)) {
    seen.pop_front();
  }
}

Placement BoardPlacer::place_one(const std::string& sensor, const Sightings& seen,
                                 const KnownPoses& placed) const {
  Placement placement = not_placed(sensor, "");
  const std::vector<alignment::TagSighting> of_lost(seen.begin(), seen.end());
  for (const auto& [other, world_from_other] : placed) {
    const auto found = seen_.find(other);
    if (found == seen_.end() || other == sensor) continue;
    const std::vector<alignment::TagSighting> of_other(found->second.begin(), found->second.end());
    const auto match = alignment::match_boards(of_other, of_lost);
    if (!match) {
      if (!placement.pose.is_placed()) placement.pose.note = match.error().message;
      continue;
    }
    const SensorPose& best = placement.pose;
    if (best.is_placed() && match->expected_error_mm >= best.expected_error_mm) continue;
    placement = placed_at(sensor, world_from_other * match->a_from_b, match->expected_error_mm);
  }
  return placement;
}

std::vector<Placement> BoardPlacer::place_relative_to(KnownPoses placed,
                                                      const std::set<std::string>& lost) const {
  std::map<std::string, Placement> answers;
  for (bool is_more_known = true; is_more_known;) {
    is_more_known = false;
    for (const std::string& sensor : lost) {
      const auto seen = seen_.find(sensor);
      if (seen == seen_.end() || answers[sensor].pose.is_placed()) continue;
      answers[sensor] = place_one(sensor, seen->second, placed);
      if (!answers[sensor].pose.is_placed()) continue;
      placed[sensor] = answers[sensor].pose.world_from_depth;
      is_more_known = true;
    }
  }
  std::vector<Placement> placements;
  for (auto& [sensor, answer] : answers) placements.push_back(std::move(answer));
  return placements;
}

std::vector<Placement> BoardPlacer::place(const KnownPoses& placed,
                                          const std::set<std::string>& lost,
                                          const Seeds& seeds) const {
  return place_or_seed(placed, lost, seeds, [this](const auto& known, const auto& others) {
    return place_relative_to(known, others);
  });
}

}  // namespace roomcast::alignment
