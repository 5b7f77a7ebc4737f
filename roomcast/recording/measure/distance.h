// SPDX-License-Identifier: Apache-2.0
// Measures the distance between two places in a room, with its expected error. A place is a pixel
// of a sensor, or a world point on a surface that a sensor sees. Its position comes from a plane
// fitted to the readings around it, so noise has little effect; the bias of depth cameras remains
// and, between two sensors, the error of their poses. If alignment could not tell the room's scale,
// as with sensors that nobody calibrated, its error is that of every distance. Metres. Thread-safe
// (no state).
#pragma once

#include <optional>
#include <span>
#include <string>

#include <Eigen/Core>

#include "roomcast/core/result.h"
#include "roomcast/recording/measure/static_room.h"

namespace roomcast::recording {

/// A place to measure from, as entered by the user: sensor and pixel, or a world point.
struct PickedPlace {
  std::string sensor;  // with `pixel`
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  std::optional<Eigen::Vector3d> world_m;  // instead of sensor and pixel
};

struct MeasuredPlace {
  Eigen::Vector3d world_m = Eigen::Vector3d::Zero();
  std::string sensor;           // the sensor that sees the place
  double expected_error_m = 0;  // standard deviation, without the error of the sensor's pose
};

struct MeasuredDistance {
  MeasuredPlace from, to;
  double distance_m = 0;
  double expected_error_m = 0;  // standard deviation
  double by_scale_m = 0;        // the part of it that the room's scale has; 0: unknown
};

/// Maximum distance of a world point from a surface to count as on it.
inline constexpr double kNearSurface_m = 0.05;

/// "s0:320,240" or "1.2,0.8,-0.4". kInvalidArgument for anything else.
[[nodiscard]] Result<PickedPlace> parse_place(const std::string& text);

/// kNotFound: unknown sensor, no reading at the pixel, or no surface near the point.
[[nodiscard]] Result<MeasuredPlace> measure_place(std::span<const StaticSensor> room,
                                                  const PickedPlace& place);
[[nodiscard]] Result<MeasuredDistance> measure_distance(std::span<const StaticSensor> room,
                                                        const PickedPlace& from,
                                                        const PickedPlace& to);

}  // namespace roomcast::recording
