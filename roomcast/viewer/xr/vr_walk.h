// SPDX-License-Identifier: Apache-2.0
// VrWalk: moves a person in a headset: thumbsticks move the stage (the piece of floor on which the
// person really walks) through the world, smoothly or by teleporting, and turn it, smoothly or in
// steps. Pure.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "roomcast/client/room/person_pose.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/viewer/view/view_settings.h"
#include "roomcast/viewer/walk/view_state.h"

namespace roomcast::viewer::xr {

/// Input of a headset and its controllers. Sticks: right and forward are positive, -1..1.
struct VrInput {
  RigidTransform stage_from_head;
  std::optional<RigidTransform> stage_from_left_hand, stage_from_right_hand;
  std::optional<RigidTransform> stage_from_aim;  // of the right hand; points along -z
  Eigen::Vector2d walk = Eigen::Vector2d::Zero(), turn = Eigen::Vector2d::Zero();
  bool points = false;     // the trigger is held
  bool recenters = false;  // pressed in this frame
};

class VrWalk {
 public:
  [[nodiscard]] const RigidTransform& world_from_stage() const { return world_from_stage_; }

  /// Moves the stage so that the head has the view's x, z and yaw; the stage's floor is at y = 0.
  void stand_at(const ViewState& view, const RigidTransform& stage_from_head);

  /// Applies the sticks for this time. Long pauses are shortened.
  void advance(const VrInput& input, const ComfortOptions& comfort, double seconds);

  /// The teleport's target on the floor; empty while not aiming or out of reach.
  [[nodiscard]] const std::optional<Eigen::Vector3d>& teleport_target_m() const {
    return target_m_;
  }

 private:
  void turn(const VrInput& input, const ComfortOptions& comfort, double seconds);
  void turn_around_head(const RigidTransform& stage_from_head, double yaw_rad);
  void walk(const VrInput& input, const ComfortOptions& comfort, double seconds);
  void teleport(const VrInput& input, bool aims);

  RigidTransform world_from_stage_;
  bool stick_is_turned_ = false;
  bool aims_ = false;
  std::optional<Eigen::Vector3d> target_m_;
};

/// Where an object thrown along `world_from_aim`'s -z lands on the floor (y = 0); empty if out of
/// reach.
[[nodiscard]] std::optional<Eigen::Vector3d> landing_place_m(const RigidTransform& world_from_aim);

}  // namespace roomcast::viewer::xr
