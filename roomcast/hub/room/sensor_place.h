// SPDX-License-Identifier: Apache-2.0
// SensorPlace: the pose of a sensor and its origin. A pose supplied by the sensor is authoritative.
// An estimated pose is replaced by later estimates. A sensor with neither gets a provisional pose,
// so that viewers can show it. After the sensor was moved no pose is valid until one is estimated
// from what it has seen since. A sensor that was offline may have been moved unnoticed, so its
// estimated pose is then unverified. Plain data and its rules. Metres, world_from_depth.
// docs/spec/wire.md §3, "Where sensors stand".
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "roomcast/core/ids.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/hub/room/known_sensor.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

struct SensorPlace {
  wire::pb::Placement placement = wire::pb::PLACEMENT_UNPLACED;
  RigidTransform world_from_depth;
  float expected_error_mm = 0;  // 0: unknown
  std::string note;             // why alignment could not place the sensor
  bool moved = false;           // the sensor was moved since this pose was set
  bool unverified = false;      // the sensor was offline since; nothing has confirmed the pose yet
  std::uint32_t valid_from_bundle = 0;  // ignore poses estimated from earlier bundles

  /// The provisional pose of the `nth` unplaced sensor: next to the room, well outside the area of
  /// the placed sensors.
  [[nodiscard]] static SensorPlace guessed(std::size_t nth,
                                           std::span<const RigidTransform> placed = {});

  /// Takes the pose that the sensor supplies in its Join, if any.
  void give(const wire::pb::SensorRole& role);
  /// Takes an aligner's result. True: the estimated pose was set or withdrawn.
  bool find(const wire::pb::SensorPlacement& found);
  /// The sensor reports that it was moved; its next bundle has the number `next_bundle`.
  void lose(std::uint32_t next_bundle);
  /// Restores the pose estimated before the hub was started, as unverified.
  void recall(const KnownPose& pose);
  /// The sensor was offline; its next bundle has the number `next_bundle`.
  void doubt(std::uint32_t next_bundle);
  /// The estimated pose; nothing: the sensor has none.
  [[nodiscard]] std::optional<KnownPose> found() const;

  void write_to(wire::pb::SensorEntry& entry) const;

 private:
  void withdraw();
};

}  // namespace roomcast::hub
