// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/service/placement.h"

#include <algorithm>

namespace roomcast::alignment {
namespace {

template <class Condition>
KnownPoses poses_where(const KnownRoom& room, Condition condition) {
  KnownPoses poses;
  for (const auto& [name, sensor] : room) {
    if (condition(sensor)) poses[name] = sensor.pose.world_from_depth;
  }
  return poses;
}

}  // namespace

Placement placed_at(const std::string& sensor, const RigidTransform& world_from_depth,
                    double expected_error_mm) {
  return {.sensor = sensor,
          .pose = {.world_from_depth = world_from_depth,
                   .source = PoseSource::kEstimated,
                   .state = PoseState::kValid,
                   .expected_error_mm = expected_error_mm,
                   .depth_scale = kOfBundle}};
}

Placement not_placed(const std::string& sensor, const std::string& reason) {
  return {.sensor = sensor, .pose = {.note = reason}};
}

KnownPoses given_poses(const KnownRoom& room) {
  return poses_where(room, [](const KnownSensor& sensor) {
    return sensor.pose.source == PoseSource::kGiven && sensor.is_connected;
  });
}

KnownPoses estimated_poses(const KnownRoom& room) {
  return poses_where(room, [](const KnownSensor& sensor) {
    return sensor.pose.source == PoseSource::kEstimated ||
           (sensor.pose.source == PoseSource::kGiven && !sensor.is_connected);
  });
}

KnownPoses stored_poses(const KnownRoom& room) {
  return poses_where(
      room, [](const KnownSensor& sensor) { return sensor.pose.source == PoseSource::kStored; });
}

KnownPoses placeholder_poses(const KnownRoom& room) {
  return poses_where(room, [](const KnownSensor& sensor) { return !sensor.pose.is_placed(); });
}

bool has_connected(const KnownPoses& poses, const KnownRoom& room) {
  return std::ranges::any_of(poses, [&](const auto& pose) {
    const auto known = room.find(pose.first);
    return known == room.end() || known->second.is_connected;
  });
}

}  // namespace roomcast::alignment
