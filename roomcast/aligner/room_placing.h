// SPDX-License-Identifier: Apache-2.0
// RoomPlacing: where the sensors of a running room stand, from the bundles that have come so far.
// The world stays where it is: when something new is known, a sensor whose pose is known already
// keeps it, and the others are placed beside it, so that the rest of the room does not jump.
// Deterministic. Single-threaded.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/align/rig/rig_aligner.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::aligner {

struct Placement {
  std::string sensor;
  std::optional<RigidTransform> world_from_depth;
  double expected_error_mm = 0;
  std::string note;                 // why it is not placed
  std::uint32_t bundle_number = 0;  // of its bundle that this was found from
};

/// Poses by the sensor's name.
using KnownPoses = std::map<std::string, RigidTransform>;

/// What the report says, moved as a whole so that one of its sensors that has a known pose keeps
/// it: the one with whom most others keep theirs, too, so that the room stays where it is when a
/// sensor was moved unnoticed; `given` goes before `found_before`.
[[nodiscard]] std::vector<Placement> placements_in_place(const align::AlignmentReport& report,
                                                         const KnownPoses& given,
                                                         const KnownPoses& found_before);

class RoomPlacing {
 public:
  /// What a sensor sees. One of that name takes the place of an earlier one. One that is of no use
  /// is reported with its reason, and what was known of the sensor is forgotten.
  void add(const align::CalibrationBundle& bundle);
  void refuse(const std::string& sensor, const std::string& reason);
  /// What was known of it no longer holds.
  void forget(const std::string& sensor);

  /// All sensors that have been added. `given`: poses that hold whatever is found; `found_before`:
  /// where the room shows the others now.
  [[nodiscard]] std::vector<Placement> solve(const KnownPoses& given,
                                             const KnownPoses& found_before);

 private:
  align::RigAligner aligner_;
  std::map<std::string, std::string> refused_;  // reasons
};

}  // namespace roomcast::aligner
