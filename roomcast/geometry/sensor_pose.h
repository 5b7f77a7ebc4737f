// SPDX-License-Identifier: Apache-2.0
// SensorPose: a sensor's pose in its room, its source and its state, from alignment through the hub
// and its store to the viewers. Metres, millimetres where a name says so. Plain data.
#pragma once

#include <cstdint>
#include <string>

#include "roomcast/geometry/rigid_transform.h"

namespace roomcast {

enum class PoseSource : std::uint8_t {
  kNone,       // the pose is unknown
  kGiven,      // supplied by the sensor: authoritative
  kEstimated,  // by alignment, from what the sensor has seen since it joined
  kStored,     // estimated before the sensor was offline or the hub was restarted
};

enum class PoseState : std::uint8_t {
  kNone,        // the pose is unknown
  kValid,       // given, or estimated
  kUnverified,  // stored, and not confirmed yet: the sensor may have been moved meanwhile
  kMoved,       // of any source: the sensor was moved since, so that the pose is invalid
};

struct SensorPose {
  RigidTransform world_from_depth = {};  // without a source: a placeholder for display
  PoseSource source = PoseSource::kNone;
  PoseState state = PoseState::kNone;
  double expected_error_mm = 0;  // of an estimated pose, 2.5 m ahead of the sensor; 0: unknown
  std::string note = {};         // for people: why alignment could not place the sensor
  double depth_scale = 1;        // factor on the camera's readings that the pose assumes

  [[nodiscard]] bool is_placed() const { return source != PoseSource::kNone; }
  /// By alignment, now or earlier.
  [[nodiscard]] bool is_estimated() const {
    return source == PoseSource::kEstimated || source == PoseSource::kStored;
  }
  [[nodiscard]] bool is_moved() const { return state == PoseState::kMoved; }
};

}  // namespace roomcast
