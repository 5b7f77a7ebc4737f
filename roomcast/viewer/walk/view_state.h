// SPDX-License-Identifier: Apache-2.0
// Where a viewer stands and looks, and how that changes: pure functions, the same as those of the
// page (web/src/view/view_state.ts). World: metres, y up. Yaw 0 looks along -z and grows to the
// left, pitch is up; the horizon stays level. The pivot is the place that orbiting turns around.
#pragma once

#include <Eigen/Core>

#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::viewer {

struct ViewState {
  Eigen::Vector3d position_m = {0, 1.6, 3};
  double yaw_rad = 0, pitch_rad = 0;
  double pivot_distance_m = 3;
};

inline constexpr double kMaxPitch_rad = 1.55;  // a little less than straight up
inline constexpr double kMinPivotDistance_m = 0.3;
inline constexpr double kMaxPivotDistance_m = 60;
/// Beyond this a pose is no longer one that the hub takes.
inline constexpr double kFarthestWalk_m = 1000;

/// Unit vector, where it looks.
[[nodiscard]] Eigen::Vector3d direction(const ViewState& view);
[[nodiscard]] Eigen::Vector3d pivot_m(const ViewState& view);
/// View frame: x right, y up, -z forward.
[[nodiscard]] RigidTransform world_from_view(const ViewState& view);

[[nodiscard]] ViewState look_from(const Eigen::Vector3d& position_m,
                                  const Eigen::Vector3d& target_m);
/// Roll is dropped.
[[nodiscard]] ViewState view_from_pose(const RigidTransform& world_from_view,
                                       double pivot_distance_m);

/// Turns the head in place.
[[nodiscard]] ViewState look(ViewState view, double yaw_rad, double pitch_rad);
/// Moves around the pivot, which stays where it is in the picture.
[[nodiscard]] ViewState orbit(const ViewState& view, double yaw_rad, double pitch_rad);
/// Moves across the picture.
[[nodiscard]] ViewState pan(ViewState view, double right_m, double up_m);
/// Goes to `factor` times the distance from the pivot; once there, pushes the pivot ahead.
[[nodiscard]] ViewState dolly(ViewState view, double factor);
/// Walks on the level, whatever the pitch.
[[nodiscard]] ViewState walk(ViewState view, double forward_m, double right_m, double up_m);

}  // namespace roomcast::viewer
