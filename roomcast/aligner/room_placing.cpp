// SPDX-License-Identifier: Apache-2.0
#include "roomcast/aligner/room_placing.h"

#include <memory>
#include <utility>

namespace roomcast::aligner {

namespace {

RigidTransform now_from_report(const align::AlignmentReport& report, const KnownPoses& given,
                               const KnownPoses& found_before) {
  for (const KnownPoses* known : {&given, &found_before}) {
    for (const align::SensorReport& sensor : report.sensors) {
      const auto pose = known->find(sensor.id);
      if (!sensor.placed || pose == known->end()) continue;
      return pose->second * sensor.world_from_depth->inverse();
    }
  }
  return {};
}

}  // namespace

std::vector<Placement> placements_in_place(const align::AlignmentReport& report,
                                           const KnownPoses& given,
                                           const KnownPoses& found_before) {
  const RigidTransform now_from_then = now_from_report(report, given, found_before);
  std::vector<Placement> placements;
  for (const align::SensorReport& sensor : report.sensors) {
    Placement& placement = placements.emplace_back();
    placement.sensor = sensor.id;
    if (sensor.placed) {
      placement.world_from_depth = now_from_then * *sensor.world_from_depth;
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

std::vector<Placement> RoomPlacing::solve(const KnownPoses& given, const KnownPoses& found_before) {
  auto placements = placements_in_place(aligner_.solve(), given, found_before);
  for (const auto& [sensor, reason] : refused_) {
    placements.push_back({.sensor = sensor, .world_from_depth = {}, .note = reason});
  }
  return placements;
}

}  // namespace roomcast::aligner
