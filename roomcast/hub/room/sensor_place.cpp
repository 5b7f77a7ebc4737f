// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/sensor_place.h"

#include <algorithm>

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

}  // namespace

/// The sensors are placed in a row along x and face the world's -z.
SensorPlace SensorPlace::guessed(std::size_t nth, std::span<const RigidTransform> placed) {
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
  SensorPlace place;
  place.world_from_depth = {Eigen::Vector3d(1, -1, -1).asDiagonal(), at_m};
  return place;
}

void SensorPlace::give(const pb::SensorRole& role) {
  if (role.world_from_depth().empty()) return;
  world_from_depth = wire::exact_transform(role.world_from_depth());
  placement = pb::PLACEMENT_GIVEN;
  expected_error_mm = 0;
  note.clear();
  moved = false;
  unverified = false;
}

bool SensorPlace::find(const pb::SensorPlacement& found) {
  if (found.bundle_number() < valid_from_bundle) return false;
  if (placement == pb::PLACEMENT_GIVEN && !moved) return false;
  note = found.note();
  if (found.withdrawn() && placement == pb::PLACEMENT_ALIGNED) {
    withdraw();
    return true;
  }
  if (found.world_from_depth().empty()) return false;
  const RigidTransform now = wire::exact_transform(found.world_from_depth());
  if (!is_the_same(now, world_from_depth)) world_from_depth = now;
  placement = pb::PLACEMENT_ALIGNED;
  expected_error_mm = found.expected_error_mm();
  moved = false;
  unverified = found.unverified();
  return true;
}

/// Keeps the note, which gives the reason. Room::announce() chooses where to show the sensor.
void SensorPlace::withdraw() {
  placement = pb::PLACEMENT_UNPLACED;
  expected_error_mm = 0;
  unverified = false;
}

void SensorPlace::lose(std::uint32_t next_bundle) {
  moved = true;
  valid_from_bundle = next_bundle;
}

void SensorPlace::recall(const KnownPose& pose) {
  world_from_depth = pose.world_from_depth;
  expected_error_mm = pose.expected_error_mm;
  placement = pb::PLACEMENT_ALIGNED;
  unverified = true;
}

void SensorPlace::doubt(std::uint32_t next_bundle) {
  if (placement != pb::PLACEMENT_ALIGNED) return;
  unverified = true;
  valid_from_bundle = next_bundle;
}

std::optional<KnownPose> SensorPlace::found() const {
  if (placement != pb::PLACEMENT_ALIGNED) return std::nullopt;
  return KnownPose{world_from_depth, expected_error_mm};
}

void SensorPlace::write_to(pb::SensorEntry& entry) const {
  wire::write_transform(world_from_depth, *entry.mutable_world_from_depth());
  entry.set_placement(placement);
  entry.set_expected_error_mm(expected_error_mm);
  entry.set_placement_note(note);
  entry.set_moved(moved);
  entry.set_unverified(unverified);
}

}  // namespace roomcast::hub
