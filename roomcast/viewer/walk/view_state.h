// SPDX-License-Identifier: Apache-2.0
// ViewState: a viewer's position and viewing direction. The functions are pure and the same as the
// page's (web/src/view/view_state.ts). World frame: metres, y up. Yaw 0 looks along -z and grows to
// the left, pitch grows upwards; there is no roll. The pivot is the point around which orbiting
// turns.
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
/// The hub rejects poses beyond this distance.
inline constexpr double kFarthestWalk_m = 1000;

/// The viewing direction, a unit vector.
[[nodiscard]] Eigen::Vector3d direction(const ViewState& view);
[[nodiscard]] Eigen::Vector3d pivot_m(const ViewState& view);
/// View frame: x right, y up, -z forward.
[[nodiscard]] RigidTransform world_from_view(const ViewState& view);

[[nodiscard]] ViewState look_from(const Eigen::Vector3d& position_m,
                                  const Eigen::Vector3d& target_m);
/// Ignores roll.
[[nodiscard]] ViewState view_from_pose(const RigidTransform& world_from_view,
                                       double pivot_distance_m);

/// Turns the head in place.
[[nodiscard]] ViewState look(ViewState view, double yaw_rad, double pitch_rad);
/// Moves around the pivot, which keeps its place in the picture.
[[nodiscard]] ViewState orbit(const ViewState& view, double yaw_rad, double pitch_rad);
/// Moves parallel to the picture.
[[nodiscard]] ViewState pan(ViewState view, double right_m, double up_m);
/// Multiplies the distance from the pivot by `factor`; when very near, pushes the pivot ahead.
[[nodiscard]] ViewState dolly(ViewState view, double factor);
/// Walks horizontally at any pitch; `up_m` is along the world's y.
[[nodiscard]] ViewState walk(ViewState view, double forward_m, double right_m, double up_m);

}  // namespace roomcast::viewer
