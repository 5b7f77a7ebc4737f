// SPDX-License-Identifier: Apache-2.0
#include "roomcast/aligner/room_placing.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "roomcast/align/pair/pose_difference.h"

namespace roomcast::aligner {

namespace {

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

}  // namespace

std::vector<Placement> placements_in_place(const align::AlignmentReport& report,
                                           const KnownPoses& given,
                                           const KnownPoses& found_before) {
  auto now_from_then = now_from_report(report, given);
  if (!now_from_then) now_from_then = now_from_report(report, found_before);
  std::vector<Placement> placements;
  for (const align::SensorReport& sensor : report.sensors) {
    Placement& placement = placements.emplace_back();
    placement.sensor = sensor.id;
    if (sensor.placed) {
      placement.world_from_depth =
          now_from_then.value_or(RigidTransform{}) * *sensor.world_from_depth;
      placement.expected_error_mm = sensor.expected_error_mm;
    } else {
      placement.note = sensor.reason;
    }
  }
  return placements;
}

void RoomPlacing::add(const align::CalibrationBundle& bundle) {
  auto view = align::make_sensor_view(bundle);
  if (!view) return refuse(bundle.name, view.error().message);
  refused_.erase(bundle.name);
  aligner_.add(std::make_shared<const align::SensorView>(*std::move(view)));
}

void RoomPlacing::refuse(const std::string& sensor, const std::string& reason) {
  aligner_.remove(sensor);
  refused_[sensor] = reason;
}

void RoomPlacing::forget(const std::string& sensor) {
  aligner_.remove(sensor);
  refused_.erase(sensor);
}

std::vector<Placement> RoomPlacing::solve(const KnownPoses& given, const KnownPoses& found_before) {
  auto placements = placements_in_place(aligner_.solve(), given, found_before);
  for (const auto& [sensor, reason] : refused_) {
    Placement& placement = placements.emplace_back();
    placement.sensor = sensor;
    placement.note = reason;
  }
  return placements;
}

}  // namespace roomcast::aligner
