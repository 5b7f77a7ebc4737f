// SPDX-License-Identifier: Apache-2.0
#include "roomcast/aligner/room_world.h"

#include <algorithm>
#include <optional>

#include "roomcast/align/pair/pose_difference.h"

namespace roomcast::aligner {
namespace {

constexpr auto kNotConnected =
    "what it sees is not connected yet with what a sensor sees whose place was given";
constexpr double kStays_m = 0.05, kStays_rad = 0.02;  // well within what alignment accepts

bool stays(const RigidTransform& known, const RigidTransform& now) {
  const auto apart = align::difference(known, now);
  return apart.distance_m < kStays_m && apart.angle_rad < kStays_rad;
}

/// How the report has to be moved so that the sensors whose poses are known stay where they are:
/// each of them proposes, and the others vote.
std::optional<RigidTransform> now_from_report(const align::AlignmentReport& report,
                                              const KnownPoses& known) {
  std::optional<RigidTransform> best;
  int most_votes = 0;
  for (const auto& anchor : report.sensors) {
    const auto pose = known.find(anchor.id);
    if (!anchor.placed || pose == known.end()) continue;
    const RigidTransform proposal = pose->second * anchor.world_from_depth->inverse();
    const auto votes = std::ranges::count_if(report.sensors, [&](const auto& sensor) {
      const auto before = known.find(sensor.id);
      return sensor.placed && before != known.end() &&
             stays(before->second, proposal * *sensor.world_from_depth);
    });
    if (votes <= most_votes) continue;
    most_votes = static_cast<int>(votes);
    best = proposal;
  }
  return best;
}

/// Without a way to move the report into the world, nobody has a place.
std::vector<Placement> placements_of(const align::AlignmentReport& report,
                                     const std::optional<RigidTransform>& now_from_report) {
  std::vector<Placement> placements;
  for (const align::SensorReport& sensor : report.sensors) {
    Placement& placement = placements.emplace_back();
    placement.sensor = sensor.id;
    if (!sensor.placed) {
      placement.note = sensor.reason;
    } else if (!now_from_report) {
      placement.note = kNotConnected;
    } else {
      placement.world_from_depth = *now_from_report * *sensor.world_from_depth;
      placement.expected_error_mm = sensor.expected_error_mm;
    }
  }
  return placements;
}

}  // namespace

std::vector<Placement> RoomWorld::place(const align::AlignmentReport& report,
                                        const KnownPoses& given, const KnownPoses& found_before) {
  const KnownPoses real = settled(given, found_before);
  auto now_from_then = now_from_report(report, given);
  if (!now_from_then) now_from_then = now_from_report(report, real);
  if (!now_from_then && given.empty()) now_from_then = RigidTransform{};
  auto placements = placements_of(report, now_from_then);
  const bool is_made_up = given.empty() && (found_before.empty() || !made_up_.empty());
  for (Placement& placement : placements) {
    if (!placement.world_from_depth) {
      placement.withdrawn = made_up_.contains(placement.sensor) && !given.empty();
    } else if (is_made_up) {
      made_up_.insert(placement.sensor);
    } else {
      made_up_.erase(placement.sensor);
    }
  }
  return placements;
}

KnownPoses RoomWorld::settled(const KnownPoses& given, const KnownPoses& found_before) const {
  KnownPoses poses = found_before;
  if (!given.empty())
    std::erase_if(poses, [&](const auto& known) { return made_up_.contains(known.first); });
  return poses;
}

}  // namespace roomcast::aligner
