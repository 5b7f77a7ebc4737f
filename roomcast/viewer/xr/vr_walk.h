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

/// A hand, with its controller or without. The stick: right and forward are positive, -1..1.
struct VrHand {
  std::optional<RigidTransform> stage_from_grip;
  std::optional<RigidTransform> stage_from_aim;  // points along -z
  Eigen::Vector2d stick = Eigen::Vector2d::Zero();
  bool points = false;   // the trigger is held
  bool selects = false;  // the only button of a simple controller is held, or fingers pinch
};

/// Input of a headset and its controllers.
struct VrInput {
  RigidTransform stage_from_head;
  VrHand left, right;
  bool recenters = false;  // asked for in this frame
  /// The headset's software has moved the stage before this frame.
  std::optional<RigidTransform> old_stage_from_stage;

  /// The hand that turns and teleports. The other one walks.
  [[nodiscard]] const VrHand& main_hand(const ComfortOptions& comfort) const {
    return comfort.left_handed ? left : right;
  }
  [[nodiscard]] const VrHand& other_hand(const ComfortOptions& comfort) const {
    return comfort.left_handed ? right : left;
  }
  /// The hand with the laser pointer; null: none points. The main hand of simple controllers
  /// teleports instead.
  [[nodiscard]] const VrHand* pointing_hand(const ComfortOptions& comfort) const;
};

class VrWalk {
 public:
  [[nodiscard]] const RigidTransform& world_from_stage() const { return world_from_stage_; }

  /// Moves the stage so that the head has the view's x, z and yaw; the stage's floor is at y = 0.
  void stand_at(const ViewState& view, const RigidTransform& stage_from_head);

  /// Keeps the person where they are in the world after the headset's software has moved the stage.
  void follow_stage(const RigidTransform& old_stage_from_stage);

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
  void teleport(const VrInput& input, const VrHand& hand, bool aims);

  RigidTransform world_from_stage_;
  bool stick_is_turned_ = false;
  bool aims_ = false;
  std::optional<Eigen::Vector3d> target_m_;
};

/// Where an object thrown along `world_from_aim`'s -z lands on the floor (y = 0); empty if out of
/// reach.
[[nodiscard]] std::optional<Eigen::Vector3d> landing_place_m(const RigidTransform& world_from_aim);

}  // namespace roomcast::viewer::xr
