// SPDX-License-Identifier: Apache-2.0
// The distance between two places of a room, and how far off it may be. A place is a pixel of a
// sensor, or a point of the world on a surface that a sensor sees. It is taken from the plane
// through the readings around it, so noise hardly counts; what stays is the bias of depth cameras
// and, between two sensors, the error of their places. Metres. Thread-safe (no state).
#pragma once

#include <optional>
#include <span>
#include <string>

#include <Eigen/Core>

#include "roomcast/core/result.h"
#include "roomcast/recording/measure/static_room.h"

namespace roomcast::recording {

/// A place to measure from, as a person gives it.
struct PickedPlace {
  std::string sensor;  // with `pixel`
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  std::optional<Eigen::Vector3d> world_m;  // instead of those
};

struct MeasuredPlace {
  Eigen::Vector3d world_m = Eigen::Vector3d::Zero();
  std::string sensor;           // that sees it
  double expected_error_m = 0;  // standard deviation, without that of the sensor's own place
};

struct MeasuredDistance {
  MeasuredPlace from, to;
  double distance_m = 0;
  double expected_error_m = 0;  // standard deviation
};

/// A point of the world that is farther from every surface is none of a surface.
inline constexpr double kNearSurface_m = 0.05;

/// "s0:320,240" or "1.2,0.8,-0.4". kInvalidArgument for anything else.
[[nodiscard]] Result<PickedPlace> parse_place(const std::string& text);

/// kNotFound: no such sensor, no reading there, no surface near the point.
[[nodiscard]] Result<MeasuredPlace> measure_place(std::span<const StaticSensor> room,
                                                  const PickedPlace& place);
[[nodiscard]] Result<MeasuredDistance> measure_distance(std::span<const StaticSensor> room,
                                                        const PickedPlace& from,
                                                        const PickedPlace& to);

}  // namespace roomcast::recording
