// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/xr/vr_walk.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace roomcast::viewer::xr {
namespace {

constexpr double kLongestStep_s = 0.1;
constexpr double kStickRest = 0.15;
constexpr double kSnapPush = 0.7, kSnapRelease = 0.4;
constexpr double kAimPush = 0.7, kAimRelease = 0.3;
constexpr double kThrow_m_per_s = 6;
constexpr double kGravity_m_per_s2 = 9.81;
constexpr double kFarthestThrow_m = 8;

double yaw_of(const RigidTransform& transform) {
  const Eigen::Vector3d forward = transform.rotation * Eigen::Vector3d(0, 0, -1);
  return std::atan2(-forward.x(), -forward.z());
}

Eigen::Matrix3d yaw_matrix(double yaw_rad) {
  return Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitY()).toRotationMatrix();
}

double beyond_rest(double axis) {
  return std::abs(axis) > kStickRest ? std::clamp(axis, -1.0, 1.0) : 0;
}

}  // namespace

const VrHand* VrInput::pointing_hand(const ComfortOptions& comfort) const {
  const VrHand &main = main_hand(comfort), &other = other_hand(comfort);
  if (main.points) return &main;
  return other.points || other.selects ? &other : nullptr;
}

void VrWalk::stand_at(const ViewState& view, const RigidTransform& stage_from_head) {
  world_from_stage_.rotation = yaw_matrix(view.yaw_rad - yaw_of(stage_from_head));
  world_from_stage_.translation_m.setZero();
  Eigen::Vector3d shift_m = view.position_m - world_from_stage_ * stage_from_head.translation_m;
  shift_m.y() = 0;
  world_from_stage_.translation_m = shift_m;
}

void VrWalk::follow_stage(const RigidTransform& old_stage_from_stage) {
  RigidTransform moved;  // on the floor
  moved.rotation = yaw_matrix(yaw_of(old_stage_from_stage));
  moved.translation_m = old_stage_from_stage.translation_m;
  moved.translation_m.y() = 0;
  world_from_stage_ = world_from_stage_ * moved;
}

void VrWalk::advance(const VrInput& input, const ComfortOptions& comfort, double seconds) {
  const double step_s = std::clamp(seconds, 0.0, kLongestStep_s);
  const VrHand &main = input.main_hand(comfort), &other = input.other_hand(comfort);
  turn(input, comfort, step_s);
  if (comfort.smooth_walk && other.stick.norm() > kStickRest) walk(input, comfort, step_s);
  // Pushing the turning stick forward teleports; without smooth walking, so does the walking stick.
  const double push = std::max(main.stick.y(), comfort.smooth_walk ? 0.0 : other.stick.y());
  teleport(input, main, main.selects || push > (aims_ ? kAimRelease : kAimPush));
}

void VrWalk::turn(const VrInput& input, const ComfortOptions& comfort, double seconds) {
  const double push = input.main_hand(comfort).stick.x();
  if (!comfort.snap_turn) {
    const double yaw_rad = -beyond_rest(push) * comfort.smooth_turn_rad_per_s * seconds;
    return turn_around_head(input.stage_from_head, yaw_rad);
  }
  const bool is_turned = std::abs(push) > (stick_is_turned_ ? kSnapRelease : kSnapPush);
  if (is_turned && !stick_is_turned_)
    turn_around_head(input.stage_from_head, -std::copysign(comfort.snap_rad, push));
  stick_is_turned_ = is_turned;
}

void VrWalk::turn_around_head(const RigidTransform& stage_from_head, double yaw_rad) {
  const Eigen::Vector3d head_m = world_from_stage_ * stage_from_head.translation_m;
  const Eigen::Matrix3d turn = yaw_matrix(yaw_rad);
  world_from_stage_.rotation = turn * world_from_stage_.rotation;
  world_from_stage_.translation_m = turn * (world_from_stage_.translation_m - head_m) + head_m;
}

/// Forward is the head's direction.
void VrWalk::walk(const VrInput& input, const ComfortOptions& comfort, double seconds) {
  const Eigen::Matrix3d forward = yaw_matrix(yaw_of(world_from_stage_ * input.stage_from_head));
  const Eigen::Vector2d& stick = input.other_hand(comfort).stick;
  const Eigen::Vector3d push(beyond_rest(stick.x()), 0, -beyond_rest(stick.y()));
  const Eigen::Vector3d step_m = comfort.walk_speed_m_per_s * seconds * (forward * push);
  world_from_stage_.translation_m = (world_from_stage_.translation_m + step_m)
                                        .cwiseMax(-kFarthestWalk_m)
                                        .cwiseMin(kFarthestWalk_m);
}

void VrWalk::teleport(const VrInput& input, const VrHand& hand, bool aims) {
  const bool lets_go = aims_ && !aims;
  aims_ = aims;
  if (aims) {
    const RigidTransform& stage_from_aim = hand.stage_from_aim.value_or(input.stage_from_head);
    target_m_ = landing_place_m(world_from_stage_ * stage_from_aim);
    return;
  }
  if (lets_go && target_m_) {
    Eigen::Vector3d step_m = *target_m_ - world_from_stage_ * input.stage_from_head.translation_m;
    step_m.y() = 0;
    world_from_stage_.translation_m += step_m;
  }
  target_m_.reset();
}

std::optional<Eigen::Vector3d> landing_place_m(const RigidTransform& world_from_aim) {
  const Eigen::Vector3d from_m = world_from_aim.translation_m;
  const Eigen::Vector3d speed = world_from_aim.rotation * Eigen::Vector3d(0, 0, -kThrow_m_per_s);
  if (!(from_m.y() >= 0)) return std::nullopt;
  // Solves from.y + speed.y t - g t^2 / 2 = 0.
  const double time_s =
      (speed.y() + std::sqrt(speed.y() * speed.y() + 2 * kGravity_m_per_s2 * from_m.y())) /
      kGravity_m_per_s2;
  Eigen::Vector3d place_m = from_m + time_s * speed;
  place_m.y() = 0;
  if ((place_m - from_m).norm() > kFarthestThrow_m) return std::nullopt;
  return place_m;
}

}  // namespace roomcast::viewer::xr
