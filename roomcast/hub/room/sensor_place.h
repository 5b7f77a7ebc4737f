// SPDX-License-Identifier: Apache-2.0
// SensorPlace: where a sensor stands and who says so. What somebody gave holds; what alignment
// found gives way to what it finds later; before either there is a guess, so that there is
// something to see. Once the sensor was moved none of it holds, until a pose is found from what it
// sees since. Whoever was away may have been moved unseen: what was found is unverified then. Plain
// data and its rules. docs/spec/wire.md §3, "Where sensors stand".
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "roomcast/core/ids.h"
#include "roomcast/hub/config/matrix4.h"
#include "roomcast/hub/room/known_sensor.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

struct SensorPlace {
  wire::pb::Placement placement = wire::pb::PLACEMENT_UNPLACED;
  Matrix4 world_from_depth{};
  float expected_error_mm = 0;          // 0: unknown
  std::string note;                     // why alignment could not place it
  bool moved = false;                   // since this pose was known
  bool unverified = false;              // the sensor was away since, and nothing has confirmed it
  std::uint32_t valid_from_bundle = 0;  // what was found from earlier bundles came too late

  /// Shown beside the room: the `nth` of those that nobody has placed, well outside of where the
  /// placed ones stand.
  [[nodiscard]] static SensorPlace guessed(std::size_t nth, std::span<const Matrix4> placed = {});

  /// What the sensor itself says; nothing changes when it says nothing.
  void give(const wire::pb::SensorRole& role);
  /// What the aligner says. True: a new pose holds, or the one before no longer.
  bool find(const wire::pb::SensorPlacement& found);
  /// The sensor says that it was moved; its next bundle will have this number.
  void lose(std::uint32_t next_bundle);
  /// What was found before the hub was started.
  void recall(const KnownPose& pose);
  /// The sensor was away; its next bundle will have this number.
  void doubt(std::uint32_t next_bundle);
  /// The pose that alignment found, if one holds.
  [[nodiscard]] std::optional<KnownPose> found() const;

  void write_to(wire::pb::SensorEntry& entry) const;

 private:
  void withdraw();
};

}  // namespace roomcast::hub
