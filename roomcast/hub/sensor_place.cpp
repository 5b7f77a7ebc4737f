// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/sensor_place.h"

#include <algorithm>

namespace roomcast::hub {

namespace pb = wire::pb;

SensorPlace SensorPlace::guessed(SensorId id) {
  constexpr double kSpacing_m = 3, kHeight_m = 1.2;
  // Optical axes to world: x right, y down -> -y, z forward -> -z.
  SensorPlace place;
  place.world_from_depth = {1, 0, 0, kSpacing_m * id.value, 0, -1, 0, kHeight_m, 0, 0, -1, 0, 0,
                            0, 0, 1};
  return place;
}

void SensorPlace::give(const pb::SensorRole& role) {
  if (role.world_from_depth().empty()) return;
  std::ranges::copy(role.world_from_depth(), world_from_depth.begin());
  placement = pb::PLACEMENT_GIVEN;
  expected_error_mm = 0;
  note.clear();
  moved = false;
}

bool SensorPlace::find(const pb::SensorPlacement& found) {
  if (found.bundle_number() < valid_from_bundle) return false;
  if (placement == pb::PLACEMENT_GIVEN && !moved) return false;
  note = found.note();
  if (found.withdrawn() && placement == pb::PLACEMENT_ALIGNED) {
    withdraw(SensorId{static_cast<std::uint16_t>(found.sensor_id())});
    return true;
  }
  if (found.world_from_depth().empty()) return false;
  std::ranges::copy(found.world_from_depth(), world_from_depth.begin());
  placement = pb::PLACEMENT_ALIGNED;
  expected_error_mm = found.expected_error_mm();
  moved = false;
  return true;
}

/// The note stays: it says why.
void SensorPlace::withdraw(SensorId id) {
  world_from_depth = guessed(id).world_from_depth;
  placement = pb::PLACEMENT_UNPLACED;
  expected_error_mm = 0;
}

void SensorPlace::lose(std::uint32_t next_bundle) {
  moved = true;
  valid_from_bundle = next_bundle;
}

void SensorPlace::recall(const KnownPose& pose) {
  world_from_depth = pose.world_from_depth;
  expected_error_mm = pose.expected_error_mm;
  placement = pb::PLACEMENT_ALIGNED;
}

std::optional<KnownPose> SensorPlace::found() const {
  if (placement != pb::PLACEMENT_ALIGNED) return std::nullopt;
  return KnownPose{world_from_depth, expected_error_mm};
}

void SensorPlace::write_to(pb::SensorEntry& entry) const {
  entry.mutable_world_from_depth()->Assign(world_from_depth.begin(), world_from_depth.end());
  entry.set_placement(placement);
  entry.set_expected_error_mm(expected_error_mm);
  entry.set_placement_note(note);
  entry.set_moved(moved);
}

}  // namespace roomcast::hub
