// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/pose_rules.h"

#include <algorithm>
#include <utility>

#include "roomcast/wire/pose_message.h"

namespace roomcast::hub {

namespace pb = wire::pb;

namespace {

/// Readers of a pose make its rotation orthonormal, which may change its last bits.
bool is_the_same(const RigidTransform& found, const RigidTransform& known) {
  constexpr double kRounding = 1e-9;
  return (found.rotation - known.rotation).cwiseAbs().maxCoeff() < kRounding &&
         (found.translation_m - known.translation_m).cwiseAbs().maxCoeff() < kRounding;
}

/// Room::send_roster() chooses where to show the sensor.
void withdraw(SensorPose& pose) {
  pose.source = PoseSource::kNone;
  pose.expected_error_mm = 0;
  if (!pose.is_moved()) pose.state = PoseState::kNone;
}

}  // namespace

/// The sensors are placed in a row along x and face the world's -z.
RigidTransform placeholder_pose(std::size_t nth, std::span<const RigidTransform> placed) {
  constexpr double kSpacing_m = 3, kHeight_m = 1.2;
  constexpr double kBeside_m = 8;  // a sensor's view reaches at most that far to the side
  Eigen::Vector3d at_m(kSpacing_m * static_cast<double>(nth), kHeight_m, 0);
  if (!placed.empty()) {
    const auto x_of = [](const RigidTransform& pose) { return pose.translation_m.x(); };
    const auto z_of = [](const RigidTransform& pose) { return pose.translation_m.z(); };
    at_m.x() += x_of(std::ranges::max(placed, {}, x_of)) + kBeside_m;
    at_m.z() = z_of(std::ranges::max(placed, {}, z_of));
  }
  // Optical axes to world: x right, y down -> -y, z forward -> -z.
  return {Eigen::Vector3d(1, -1, -1).asDiagonal(), at_m};
}

void take_given(const pb::SensorRole& role, SensorPose& pose) {
  if (role.world_from_depth().empty()) return;
  pose = {.world_from_depth = wire::exact_transform(role.world_from_depth()),
          .source = PoseSource::kGiven,
          .state = PoseState::kValid};
}

bool take_estimate(const pb::SensorPlacement& found, SensorPose& pose) {
  if (pose.source == PoseSource::kGiven && !pose.is_moved()) return false;
  pose.note = found.note();
  if (found.withdrawn() && pose.is_estimated()) {
    withdraw(pose);
    return true;
  }
  SensorPose now = wire::read_pose(found);
  if (!now.is_placed()) return false;
  if (found.depth_scale() == 0) now.depth_scale = pose.depth_scale;
  if (is_the_same(now.world_from_depth, pose.world_from_depth))
    now.world_from_depth = pose.world_from_depth;
  pose = std::move(now);
  return true;
}

void doubt(SensorPose& pose) {
  if (!pose.is_estimated()) return;
  pose.source = PoseSource::kStored;
  if (!pose.is_moved()) pose.state = PoseState::kUnverified;
}

void confirm(SensorPose& pose) {
  if (pose.source != PoseSource::kStored) return;
  pose.source = PoseSource::kEstimated;
  if (!pose.is_moved()) pose.state = PoseState::kValid;
}

}  // namespace roomcast::hub
