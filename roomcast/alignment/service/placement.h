// SPDX-License-Identifier: Apache-2.0
// Where a sensor stands, or why nobody can tell. Metres, millimetres where a name says so. Plain
// data.
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
  std::string note;                 // why it is not placed
  std::uint32_t bundle_number = 0;  // of its bundle that this was found from
  bool withdrawn = false;           // where it was found before it does not stand, either
};

/// Poses by the sensor's name.
using KnownPoses = std::map<std::string, RigidTransform>;

/// Where the room shows its sensors.
struct KnownRoom {
  KnownPoses given;            // they hold whatever is found
  KnownPoses found;            // by what sensors see
  KnownPoses remembered;       // found once; who was away since may have been moved
  KnownPoses provisional;      // of those that nobody could place yet
  std::set<std::string> away;  // of all of them those that are not here now
};

/// Where the first of these would stand, in this order, if the world were made for it.
using Seeds = std::vector<std::pair<std::string, RigidTransform>>;

/// Makes a place that was found by something else more exact by what the sensor shares with others,
/// where that can be.
using Settle = std::function<void(Placement& found, const KnownPoses& placed)>;

}  // namespace roomcast::alignment
