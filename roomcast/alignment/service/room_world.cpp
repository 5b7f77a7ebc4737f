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

/// Whether the room knows the sensor with the same factor on its readings.
bool has_same_depth_scale(const alignment::SensorReport& sensor, const KnownRoom& room) {
  constexpr double kRounding = 1e-9;
  const auto known = room.find(sensor.id);
  return known == room.end() ||
         std::abs(known->second.pose.depth_scale - sensor.depth_scale) < kRounding;
}

/// Without an anchor no sensor gets a pose. `keep`: a sensor keeps its pose there if the new one
/// equals it within the expected error and assumes the same depth.
std::vector<Placement> placements_of(const alignment::AlignmentReport& report,
                                     const std::optional<Anchor>& anchor, const KnownPoses& keep,
                                     const KnownRoom& room) {
  std::vector<Placement> placements;
  for (const alignment::SensorReport& sensor : report.sensors) {
    if (!sensor.placed) {
      placements.push_back(not_placed(sensor.id, sensor.reason));
    } else if (!anchor) {
      placements.push_back(not_placed(sensor.id, kNotConnected));
    } else {
      const RigidTransform now = anchor->now_from_report * *sensor.world_from_depth;
      const auto before = keep.find(sensor.id);
      const double error_mm = std::hypot(sensor.expected_error_mm, anchor->expected_error_mm);
      const bool keeps = before != keep.end() && has_same_depth_scale(sensor, room) &&
                         is_same_place(before->second, now, error_mm);
      placements.push_back(
          placed_at(sensor.id, keeps ? before->second : now, sensor.expected_error_mm));
      placements.back().pose.depth_scale = sensor.depth_scale;
    }
  }
  return placements;
}

/// The anchor of the report in the room; nothing if the transform is not determined.
std::optional<Anchor> anchor_in(const KnownRoom& known, const KnownPoses& estimated,
                                const alignment::AlignmentReport& report, LoneStoredPose lone) {
  constexpr int kAgree = 2;
  const KnownPoses given = given_poses(known), stored = stored_poses(known);
  for (const KnownPoses& poses : {given, estimated}) {
    if (const Anchor anchor = anchor_of(report, poses); anchor.votes > 0) return anchor;
  }
  const bool has_world = !given.empty() || has_connected(estimated, known);
  const Anchor by_stored = anchor_of(report, stored);
  const bool needs_others = has_world || lone == LoneStoredPose::kDoubted;
  if (by_stored.votes >= (needs_others ? kAgree : 1)) return by_stored;
  if (has_world || has_connected(stored, known)) return std::nullopt;
  return Anchor{};  // a provisional world
}

/// A sensor that is alone in the report was placed relative to itself only.
void drop_lone_stored_pose(const KnownPoses& stored, std::vector<Placement>& placements) {
  if (placements.size() == 1 && stored.contains(placements[0].sensor))
    placements[0] = not_placed(placements[0].sensor, kAlone);
}

}  // namespace

std::vector<Placement> RoomWorld::place(const alignment::AlignmentReport& report,
                                        const KnownRoom& known, LoneStoredPose lone_stored_pose) {
  const KnownPoses given = given_poses(known), stored = stored_poses(known);
  KnownPoses estimated = estimated_in_world(known);
  const auto lone = lone_world(report, known);
  if (lone) estimated.erase(*lone);
  KnownPoses keep = stored;
  for (const KnownPoses& poses : {estimated, given}) {
    for (const auto& [sensor, pose] : poses) keep[sensor] = pose;
  }
  auto placements =
      placements_of(report, anchor_in(known, estimated, report, lone_stored_pose), keep, known);
  drop_lone_stored_pose(stored, placements);
  const bool is_provisional =
      given.empty() && stored.empty() && (estimated_poses(known).empty() || !provisional_.empty());
  for (Placement& placement : placements) {
    if (!placement.pose.is_placed()) {
      placement.withdrawn =
          placement.sensor == lone || (provisional_.contains(placement.sensor) && !given.empty());
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
  if (!given_poses(known).empty() || has_connected(stored_poses(known), known)) return std::nullopt;
  std::optional<std::string> lone;
  for (const auto& [sensor, pose] : estimated_poses(known)) {
    if (!known.at(sensor).is_connected) continue;
    if (lone || !provisional_.contains(sensor)) return std::nullopt;
    lone = sensor;
  }
  const auto reported =
      std::ranges::find(report.sensors, lone.value_or(""), &alignment::SensorReport::id);
  const bool others = std::ranges::any_of(report.sensors, &alignment::SensorReport::placed);
  if (reported == report.sensors.end() || reported->placed || !others) return std::nullopt;
  return lone;
}

KnownPoses RoomWorld::estimated_in_world(const KnownRoom& known) const {
  KnownPoses poses = estimated_poses(known);
  if (!given_poses(known).empty())
    std::erase_if(poses, [&](const auto& pose) { return provisional_.contains(pose.first); });
  return poses;
}

}  // namespace roomcast::alignment
