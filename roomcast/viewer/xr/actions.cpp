// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/xr/actions.h"

#include <cstring>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "roomcast/viewer/xr/eye_picture.h"
#include "roomcast/viewer/xr/xr_status.h"
#include "roomcast/viewer/xr/xr_struct.h"

namespace roomcast::viewer::xr {
namespace {

/// A controller's OpenXR paths. Empty: the controller does not have that part.
struct Controller {
  const char* profile;
  const char* walk;
  const char* turn;
  const char* point;
  const char* recenter;
};

constexpr Controller kControllers[] = {
    {"/interaction_profiles/khr/simple_controller", "", "", "/user/hand/right/input/select/click",
     "/user/hand/left/input/menu/click"},
    {"/interaction_profiles/oculus/touch_controller", "/user/hand/left/input/thumbstick",
     "/user/hand/right/input/thumbstick", "/user/hand/right/input/trigger/value",
     "/user/hand/left/input/y/click"},
    {"/interaction_profiles/valve/index_controller", "/user/hand/left/input/thumbstick",
     "/user/hand/right/input/thumbstick", "/user/hand/right/input/trigger/click",
     "/user/hand/left/input/b/click"},
    {"/interaction_profiles/microsoft/motion_controller", "/user/hand/left/input/thumbstick",
     "/user/hand/right/input/thumbstick", "/user/hand/right/input/trigger/value",
     "/user/hand/left/input/menu/click"},
    {"/interaction_profiles/htc/vive_controller", "/user/hand/left/input/trackpad",
     "/user/hand/right/input/trackpad", "/user/hand/right/input/trigger/click",
     "/user/hand/left/input/menu/click"},
};
constexpr const char* kHands[] = {"/user/hand/left", "/user/hand/right"};

Result<XrPath> path_of(XrInstance instance, const std::string& name) {
  XrPath path = XR_NULL_PATH;
  ROOMCAST_XR_TRY(xrStringToPath(instance, name.c_str(), &path), "naming a controller's part");
  return path;
}

template <std::size_t N>
void copy_name(char (&field)[N], const char* name) {
  std::strncpy(field, name, N - 1);
}

Result<XrAction> make_action(XrActionSet set, XrActionType type, const char* name,
                             const char* for_people, std::span<const XrPath> hands = {}) {
  auto info = xr_struct<XrActionCreateInfo>(XR_TYPE_ACTION_CREATE_INFO);
  info.actionType = type;
  copy_name(info.actionName, name);
  copy_name(info.localizedActionName, for_people);
  info.countSubactionPaths = static_cast<std::uint32_t>(hands.size());
  info.subactionPaths = hands.data();
  XrAction action = XR_NULL_HANDLE;
  ROOMCAST_XR_TRY(xrCreateAction(set, &info, &action), "naming what hands do");
  return action;
}

XrActionStateGetInfo question(XrAction action) {
  auto info = xr_struct<XrActionStateGetInfo>(XR_TYPE_ACTION_STATE_GET_INFO);
  info.action = action;
  return info;
}

Result<Eigen::Vector2d> stick(XrSession session, XrAction action) {
  const XrActionStateGetInfo info = question(action);
  auto state = xr_struct<XrActionStateVector2f>(XR_TYPE_ACTION_STATE_VECTOR2F);
  ROOMCAST_XR_TRY(xrGetActionStateVector2f(session, &info, &state), "reading a stick");
  if (!state.isActive) return Eigen::Vector2d(0, 0);
  return Eigen::Vector2d(state.currentState.x, state.currentState.y);
}

Result<XrActionStateBoolean> button(XrSession session, XrAction action) {
  const XrActionStateGetInfo info = question(action);
  auto state = xr_struct<XrActionStateBoolean>(XR_TYPE_ACTION_STATE_BOOLEAN);
  ROOMCAST_XR_TRY(xrGetActionStateBoolean(session, &info, &state), "reading a button");
  return state;
}

/// Empty while the hand is not tracked.
Result<std::optional<RigidTransform>> place_of(XrSpace part, XrSpace stage, XrTime time) {
  auto location = xr_struct<XrSpaceLocation>(XR_TYPE_SPACE_LOCATION);
  ROOMCAST_XR_TRY(xrLocateSpace(part, stage, time, &location), "asking where a hand is");
  constexpr XrSpaceLocationFlags kBoth =
      XR_SPACE_LOCATION_POSITION_VALID_BIT | XR_SPACE_LOCATION_ORIENTATION_VALID_BIT;
  if ((location.locationFlags & kBoth) != kBoth) return std::optional<RigidTransform>();
  return std::optional(transform_from_pose(location.pose));
}

}  // namespace

Result<Actions> Actions::create(XrInstance instance, XrSession session) {
  Actions actions;
  if (auto status = actions.make_actions(instance); !status) return status.error();
  if (auto status = actions.suggest_bindings(instance); !status) return status.error();
  if (auto status = actions.attach(session); !status) return status.error();
  return actions;
}

Status Actions::make_actions(XrInstance instance) {
  auto info = xr_struct<XrActionSetCreateInfo>(XR_TYPE_ACTION_SET_CREATE_INFO);
  copy_name(info.actionSetName, "room");
  copy_name(info.localizedActionSetName, "In the room");
  ROOMCAST_XR_TRY(xrCreateActionSet(instance, &info, &set_), "naming what hands do");
  for (const Hand hand : {kLeft, kRight}) {
    const auto path = path_of(instance, kHands[hand]);
    if (!path) return path.error();
    hands_[hand] = *path;
  }
  const auto make = [&](XrAction& made, XrActionType type, const char* name, const char* for_people,
                        bool of_each_hand = false) -> Status {
    const std::span<const XrPath> hands =
        of_each_hand ? std::span<const XrPath>(hands_) : std::span<const XrPath>();
    auto action = make_action(set_, type, name, for_people, hands);
    if (!action) return action.error();
    made = *action;
    return {};
  };
  for (const Status& status :
       {make(walk_, XR_ACTION_TYPE_VECTOR2F_INPUT, "walk", "Walk"),
        make(turn_, XR_ACTION_TYPE_VECTOR2F_INPUT, "turn", "Turn; forward: teleport"),
        make(point_, XR_ACTION_TYPE_BOOLEAN_INPUT, "point", "Laser pointer"),
        make(recenter_, XR_ACTION_TYPE_BOOLEAN_INPUT, "recenter", "Back to the start"),
        make(grip_, XR_ACTION_TYPE_POSE_INPUT, "hand", "Hand", true),
        make(aim_, XR_ACTION_TYPE_POSE_INPUT, "aim", "Where the hand points", true)}) {
    if (!status) return status;
  }
  return {};
}

Status Actions::suggest_bindings(XrInstance instance) const {
  bool one_was_taken = false;
  Status fault;
  for (const Controller& controller : kControllers) {
    std::vector<XrActionSuggestedBinding> bindings;
    const auto bind = [&](XrAction action, const std::string& part) {
      if (part.empty()) return;
      const auto path = path_of(instance, part);
      if (path) bindings.push_back({action, *path});
    };
    bind(walk_, controller.walk);
    bind(turn_, controller.turn);
    bind(point_, controller.point);
    bind(recenter_, controller.recenter);
    for (const std::string hand : kHands) {
      bind(grip_, hand + "/input/grip/pose");
      bind(aim_, hand + "/input/aim/pose");
    }
    const auto profile = path_of(instance, controller.profile);
    if (!profile) return profile.error();
    auto suggestion = xr_struct<XrInteractionProfileSuggestedBinding>(
        XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING);
    suggestion.interactionProfile = *profile;
    suggestion.suggestedBindings = bindings.data();
    suggestion.countSuggestedBindings = static_cast<std::uint32_t>(bindings.size());
    fault =
        xr_status(xrSuggestInteractionProfileBindings(instance, &suggestion), "naming controllers");
    one_was_taken |= fault.ok();
  }
  return one_was_taken ? Status{} : fault;  // a runtime need not support all controllers
}

Status Actions::attach(XrSession session) {
  auto info = xr_struct<XrSessionActionSetsAttachInfo>(XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO);
  info.countActionSets = 1;
  info.actionSets = &set_;
  ROOMCAST_XR_TRY(xrAttachSessionActionSets(session, &info), "asking for the controllers");
  const auto make = [&](XrSpace& made, XrAction action, Hand hand) -> Status {
    auto space = hand_space(session, action, hand);
    if (!space) return space.error();
    made = *space;
    return {};
  };
  if (auto status = make(left_grip_, grip_, kLeft); !status) return status;
  if (auto status = make(right_grip_, grip_, kRight); !status) return status;
  return make(right_aim_, aim_, kRight);
}

Result<XrSpace> Actions::hand_space(XrSession session, XrAction action, Hand hand) const {
  auto info = xr_struct<XrActionSpaceCreateInfo>(XR_TYPE_ACTION_SPACE_CREATE_INFO);
  info.action = action;
  info.subactionPath = hands_[hand];
  info.poseInActionSpace.orientation.w = 1;
  XrSpace space = XR_NULL_HANDLE;
  ROOMCAST_XR_TRY(xrCreateActionSpace(session, &info, &space), "asking where hands are");
  return space;
}

Status Actions::read(XrSession session, XrSpace stage, XrTime time, VrInput& input) const {
  const XrActiveActionSet active{set_, XR_NULL_PATH};
  auto sync = xr_struct<XrActionsSyncInfo>(XR_TYPE_ACTIONS_SYNC_INFO);
  sync.countActiveActionSets = 1;
  sync.activeActionSets = &active;
  ROOMCAST_XR_TRY(xrSyncActions(session, &sync), "reading the controllers");
  const auto walk = stick(session, walk_), turn = stick(session, turn_);
  if (!walk) return walk.error();
  if (!turn) return turn.error();
  const auto point = button(session, point_), recenter = button(session, recenter_);
  if (!point) return point.error();
  if (!recenter) return recenter.error();
  auto left = place_of(left_grip_, stage, time), right = place_of(right_grip_, stage, time),
       aim = place_of(right_aim_, stage, time);
  for (const auto* place : {&left, &right, &aim}) {
    if (!*place) return place->error();
  }
  input.walk = *walk;
  input.turn = *turn;
  input.points = point->isActive && point->currentState;
  input.recenters = recenter->isActive && recenter->currentState && recenter->changedSinceLastSync;
  input.stage_from_left_hand = *left;
  input.stage_from_right_hand = *right;
  input.stage_from_aim = *aim;
  return {};
}

Actions::~Actions() {
  for (const XrSpace space : {left_grip_, right_grip_, right_aim_}) {
    if (space != XR_NULL_HANDLE) xrDestroySpace(space);
  }
  if (set_ != XR_NULL_HANDLE) xrDestroyActionSet(set_);  // destroys its actions, too
}

Actions::Actions(Actions&& other) noexcept {
  *this = std::move(other);
}

Actions& Actions::operator=(Actions&& other) noexcept {
  std::swap(set_, other.set_);
  std::swap(walk_, other.walk_);
  std::swap(turn_, other.turn_);
  std::swap(point_, other.point_);
  std::swap(recenter_, other.recenter_);
  std::swap(grip_, other.grip_);
  std::swap(aim_, other.aim_);
  std::swap(hands_, other.hands_);
  std::swap(left_grip_, other.left_grip_);
  std::swap(right_grip_, other.right_grip_);
  std::swap(right_aim_, other.right_aim_);
  return *this;
}

}  // namespace roomcast::viewer::xr
