// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/walk/view_state.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace roomcast::viewer {
namespace {

/// Stops at kFarthestWalk_m.
ViewState moved_by(ViewState view, const Eigen::Vector3d& step_m) {
  view.position_m = (view.position_m + step_m).cwiseMax(-kFarthestWalk_m).cwiseMin(kFarthestWalk_m);
  return view;
}

double clamped_pitch(double pitch_rad) {
  return std::clamp(pitch_rad, -kMaxPitch_rad, kMaxPitch_rad);
}

double clamped_distance(double distance_m) {
  return std::clamp(distance_m, kMinPivotDistance_m, kMaxPivotDistance_m);
}

}  // namespace

Eigen::Vector3d direction(const ViewState& view) {
  return {-std::sin(view.yaw_rad) * std::cos(view.pitch_rad), std::sin(view.pitch_rad),
          -std::cos(view.yaw_rad) * std::cos(view.pitch_rad)};
}

Eigen::Vector3d pivot_m(const ViewState& view) {
  return view.position_m + view.pivot_distance_m * direction(view);
}

RigidTransform world_from_view(const ViewState& view) {
  const Eigen::AngleAxisd yaw(view.yaw_rad, Eigen::Vector3d::UnitY());
  const Eigen::AngleAxisd pitch(view.pitch_rad, Eigen::Vector3d::UnitX());
  return {(yaw * pitch).toRotationMatrix(), view.position_m};
}

ViewState look_from(const Eigen::Vector3d& position_m, const Eigen::Vector3d& target_m) {
  const Eigen::Vector3d gaze_m = target_m - position_m;
  const double level_m = std::hypot(gaze_m.x(), gaze_m.z());
  ViewState view;
  view.position_m = position_m;
  view.yaw_rad = level_m > 1e-6 ? std::atan2(-gaze_m.x(), -gaze_m.z()) : 0;
  view.pitch_rad = clamped_pitch(std::atan2(gaze_m.y(), level_m));
  view.pivot_distance_m = clamped_distance(gaze_m.norm());
  return view;
}

ViewState view_from_pose(const RigidTransform& world_from_view, double pivot_distance_m) {
  const Eigen::Vector3d gaze = world_from_view.rotation * Eigen::Vector3d(0, 0, -1);
  return look_from(world_from_view.translation_m,
                   world_from_view.translation_m + pivot_distance_m * gaze);
}

ViewState look(ViewState view, double yaw_rad, double pitch_rad) {
  view.yaw_rad = std::remainder(view.yaw_rad + yaw_rad, 2 * EIGEN_PI);
  view.pitch_rad = clamped_pitch(view.pitch_rad + pitch_rad);
  return view;
}

ViewState orbit(const ViewState& view, double yaw_rad, double pitch_rad) {
  const ViewState turned = look(view, yaw_rad, pitch_rad);
  return moved_by(turned, pivot_m(view) - pivot_m(turned));
}

ViewState pan(ViewState view, double right_m, double up_m) {
  return moved_by(view, world_from_view(view).rotation * Eigen::Vector3d(right_m, up_m, 0));
}

ViewState dolly(ViewState view, double factor) {
  const double forward_m = view.pivot_distance_m * (1 - factor);
  view.pivot_distance_m = clamped_distance(view.pivot_distance_m * factor);
  return moved_by(view, forward_m * direction(view));
}

ViewState walk(ViewState view, double forward_m, double right_m, double up_m) {
  const double sin = std::sin(view.yaw_rad), cos = std::cos(view.yaw_rad);
  return moved_by(view, {-sin * forward_m + cos * right_m, up_m, -cos * forward_m - sin * right_m});
}

}  // namespace roomcast::viewer
