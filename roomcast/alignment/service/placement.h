// SPDX-License-Identifier: Apache-2.0
// The estimated pose of a sensor, or the reason why there is none. Metres, millimetres where a name
// says so. Plain data.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::alignment {

struct Placement {
  std::string sensor;
  std::optional<RigidTransform> world_from_depth;
  double expected_error_mm = 0;
  std::string note;                 // the reason why it is not placed
  std::uint32_t bundle_number = 0;  // of the bundle that the pose was estimated from
  bool withdrawn = false;           // its earlier estimated pose is invalid, too
};

/// Poses by the sensor's name.
using KnownPoses = std::map<std::string, RigidTransform>;

/// The poses of the sensors in the roster, by origin.
struct KnownRoom {
  KnownPoses given;        // supplied by sensors: authoritative
  KnownPoses found;        // estimated; also given by sensors that are not connected now
  KnownPoses remembered;   // estimated earlier; the sensor was away since and may have been moved
  KnownPoses provisional;  // placeholders of sensors that could not be placed yet
  std::set<std::string> away;  // those of all of them that are not connected now
};

/// Candidates for the sensor that defines the world, in order of preference, with the pose each
/// would have.
using Seeds = std::vector<std::pair<std::string, RigidTransform>>;

/// Refines a pose that was estimated without overlap by the surfaces that the sensor shares with
/// placed ones, if that is possible.
using Settle = std::function<void(Placement& found, const KnownPoses& placed)>;

}  // namespace roomcast::alignment
