// SPDX-License-Identifier: Apache-2.0
// Input and output of the placement of a room's sensors: what the roster says about each sensor,
// and the pose that was estimated for it, or the reason why there is none. Plain data.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/geometry/sensor_pose.h"

namespace roomcast::alignment {

/// A pose's depth scale: the factor that the sensor has applied to the readings of its bundle.
inline constexpr double kOfBundle = 0;

struct Placement {
  std::string sensor;
  SensorPose pose;                  // estimated; or none, and its note says why
  std::uint32_t bundle_number = 0;  // of the bundle that the pose was estimated from
  bool withdrawn = false;           // its earlier estimated pose is invalid, too
};

/// With the bundle's depth scale.
[[nodiscard]] Placement placed_at(const std::string& sensor, const RigidTransform& world_from_depth,
                                  double expected_error_mm);
[[nodiscard]] Placement not_placed(const std::string& sensor, const std::string& reason);

/// Poses by the sensor's name.
using KnownPoses = std::map<std::string, RigidTransform>;

struct KnownSensor {
  SensorPose pose;
  bool is_connected = true;
};

/// The sensors of the roster by name, without those that were moved.
using KnownRoom = std::map<std::string, KnownSensor>;

/// Supplied by sensors that are connected: authoritative.
[[nodiscard]] KnownPoses given_poses(const KnownRoom& room);
/// Estimated; also given by sensors that are not connected now.
[[nodiscard]] KnownPoses estimated_poses(const KnownRoom& room);
/// Estimated earlier and not verified: the sensor was offline since and may have been moved.
[[nodiscard]] KnownPoses stored_poses(const KnownRoom& room);
/// Placeholders of sensors that could not be placed yet.
[[nodiscard]] KnownPoses placeholder_poses(const KnownRoom& room);

/// Whether one of the poses is of a sensor that is connected, or that the roster does not list.
[[nodiscard]] bool has_connected(const KnownPoses& poses, const KnownRoom& room);

/// Candidates for the sensor that defines the world, in order of preference, with the pose each
/// would have.
using Seeds = std::vector<std::pair<std::string, RigidTransform>>;

/// Refines a pose that was estimated without overlap by the surfaces that the sensor shares with
/// placed ones, if that is possible; else returns it as it is.
using RefinePlacement = std::function<Placement(Placement found, const KnownPoses& placed)>;

}  // namespace roomcast::alignment
