// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/service/room_world.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "roomcast/alignment/service/expected_error.h"

namespace roomcast::alignment {
namespace {

constexpr auto kNotConnected = "no overlap yet with a placed sensor";
constexpr auto kAlone = "there is no other sensor to compare it with";

/// The transform of a report into the room.
struct Anchor {
  RigidTransform now_from_report;
  double expected_error_mm = 0;  // of the sensor that keeps its pose
  int votes = 0;                 // sensors that keep theirs, including itself
};

/// The transform of the report that lets the sensors with known poses keep them: each of them
/// proposes one, and the others vote.
Anchor anchor_of(const alignment::AlignmentReport& report, const KnownPoses& known) {
  Anchor best;
  for (const auto& anchor : report.sensors) {
    const auto pose = known.find(anchor.id);
    if (!anchor.placed || pose == known.end()) continue;
    const RigidTransform proposal = pose->second * anchor.world_from_depth->inverse();
    const auto votes = std::ranges::count_if(report.sensors, [&](const auto& sensor) {
      const auto before = known.find(sensor.id);
      return sensor.placed && before != known.end() &&
             is_about_the_same_place(before->second, proposal * *sensor.world_from_depth);
    });
    if (votes > best.votes) best = {proposal, anchor.expected_error_mm, static_cast<int>(votes)};
  }
  return best;
}

/// Without an anchor no sensor gets a pose. `known`: a sensor keeps its pose there if the new one
/// equals it within the expected error.
std::vector<Placement> placements_of(const alignment::AlignmentReport& report,
                                     const std::optional<Anchor>& anchor, const KnownPoses& known) {
  std::vector<Placement> placements;
  for (const alignment::SensorReport& sensor : report.sensors) {
    Placement& placement = placements.emplace_back();
    placement.sensor = sensor.id;
    if (!sensor.placed) {
      placement.note = sensor.reason;
    } else if (!anchor) {
      placement.note = kNotConnected;
    } else {
      const RigidTransform now = anchor->now_from_report * *sensor.world_from_depth;
      const auto before = known.find(sensor.id);
      const double error_mm = std::hypot(sensor.expected_error_mm, anchor->expected_error_mm);
      const bool keeps = before != known.end() && is_same_place(before->second, now, error_mm);
      placement.world_from_depth = keeps ? before->second : now;
      placement.expected_error_mm = sensor.expected_error_mm;
    }
  }
  return placements;
}

auto count_here(const KnownPoses& poses, const std::set<std::string>& away) {
  return std::ranges::count_if(poses, [&](const auto& pose) { return !away.contains(pose.first); });
}

/// The anchor of the report in the room; nothing if the transform is not determined.
std::optional<Anchor> anchor_in(const KnownRoom& known, const KnownPoses& found,
                                const alignment::AlignmentReport& report, LoneStoredPose lone) {
  constexpr int kAgree = 2;
  for (const KnownPoses& poses : {known.given, found}) {
    if (const Anchor anchor = anchor_of(report, poses); anchor.votes > 0) return anchor;
  }
  const bool is_settled = !known.given.empty() || count_here(found, known.away) > 0;
  const Anchor remembered = anchor_of(report, known.remembered);
  const bool needs_others = is_settled || lone == LoneStoredPose::kDoubted;
  if (remembered.votes >= (needs_others ? kAgree : 1)) return remembered;
  if (is_settled || count_here(known.remembered, known.away) > 0) return std::nullopt;
  return Anchor{};  // a provisional world
}

/// A sensor that is alone in the report was placed relative to itself only.
void drop_lone_stored_pose(const KnownPoses& remembered, std::vector<Placement>& placements) {
  if (placements.size() != 1 || !remembered.contains(placements[0].sensor)) return;
  placements[0].world_from_depth.reset();
  placements[0].expected_error_mm = 0;
  placements[0].note = kAlone;
}

}  // namespace

std::vector<Placement> RoomWorld::place(const alignment::AlignmentReport& report,
                                        const KnownRoom& known, LoneStoredPose lone_stored_pose) {
  KnownPoses found = settled(known);
  const auto lone = lone_world(report, known);
  if (lone) found.erase(*lone);
  KnownPoses keep = known.remembered;
  for (const KnownPoses& poses : {found, known.given}) {
    for (const auto& [sensor, pose] : poses) keep[sensor] = pose;
  }
  auto placements = placements_of(report, anchor_in(known, found, report, lone_stored_pose), keep);
  drop_lone_stored_pose(known.remembered, placements);
  const bool is_provisional = known.given.empty() && known.remembered.empty() &&
                              (known.found.empty() || !provisional_.empty());
  for (Placement& placement : placements) {
    if (!placement.world_from_depth) {
      placement.withdrawn = placement.sensor == lone ||
                            (provisional_.contains(placement.sensor) && !known.given.empty());
    } else if (is_provisional) {
      provisional_.insert(placement.sensor);
    } else {
      provisional_.erase(placement.sensor);
    }
  }
  return placements;
}

std::optional<std::string> RoomWorld::lone_world(const alignment::AlignmentReport& report,
                                                 const KnownRoom& known) const {
  if (!known.given.empty() || count_here(known.remembered, known.away) > 0) return std::nullopt;
  std::optional<std::string> lone;
  for (const auto& [sensor, pose] : known.found) {
    if (known.away.contains(sensor)) continue;
    if (lone || !provisional_.contains(sensor)) return std::nullopt;
    lone = sensor;
  }
  const auto says =
      std::ranges::find(report.sensors, lone.value_or(""), &alignment::SensorReport::id);
  const bool others = std::ranges::any_of(report.sensors, &alignment::SensorReport::placed);
  if (says == report.sensors.end() || says->placed || !others) return std::nullopt;
  return lone;
}

KnownPoses RoomWorld::settled(const KnownRoom& known) const {
  KnownPoses poses = known.found;
  if (!known.given.empty())
    std::erase_if(poses, [&](const auto& pose) { return provisional_.contains(pose.first); });
  return poses;
}

}  // namespace roomcast::alignment
