// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/xr/actions.h"

#include <cstring>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "roomcast/viewer/xr/controllers.h"
#include "roomcast/viewer/xr/eye_picture.h"
#include "roomcast/viewer/xr/xr_status.h"
#include "roomcast/viewer/xr/xr_struct.h"

namespace roomcast::viewer::xr {
namespace {

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

XrActionStateGetInfo question(XrAction action, XrPath hand) {
  auto info = xr_struct<XrActionStateGetInfo>(XR_TYPE_ACTION_STATE_GET_INFO);
  info.action = action;
  info.subactionPath = hand;
  return info;
}

Result<Eigen::Vector2d> stick(XrSession session, XrAction action) {
  const XrActionStateGetInfo info = question(action, XR_NULL_PATH);
  auto state = xr_struct<XrActionStateVector2f>(XR_TYPE_ACTION_STATE_VECTOR2F);
  ROOMCAST_XR_TRY(xrGetActionStateVector2f(session, &info, &state), "reading a stick");
  if (!state.isActive) return Eigen::Vector2d(0, 0);
  return Eigen::Vector2d(state.currentState.x, state.currentState.y);
}

/// `hand`: of actions of each hand.
Result<XrActionStateBoolean> button(XrSession session, XrAction action,
                                    XrPath hand = XR_NULL_PATH) {
  const XrActionStateGetInfo info = question(action, hand);
  auto state = xr_struct<XrActionStateBoolean>(XR_TYPE_ACTION_STATE_BOOLEAN);
  ROOMCAST_XR_TRY(xrGetActionStateBoolean(session, &info, &state), "reading a button");
  return state;
}

bool is_held(const XrActionStateBoolean& button) {
  return button.isActive && button.currentState;
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

Result<Actions> Actions::create(const Runtime& runtime, XrSession session) {
  Actions actions;
  if (auto status = actions.make_actions(runtime.instance()); !status) return status.error();
  if (auto status = actions.suggest_bindings(runtime); !status) return status.error();
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
       {make(sticks_[kLeft], XR_ACTION_TYPE_VECTOR2F_INPUT, "walk", "Walk"),
        make(sticks_[kRight], XR_ACTION_TYPE_VECTOR2F_INPUT, "turn", "Turn; forward: teleport"),
        make(press_, XR_ACTION_TYPE_BOOLEAN_INPUT, "press", "Use the trackpad", true),
        make(point_, XR_ACTION_TYPE_BOOLEAN_INPUT, "point", "Laser pointer", true),
        make(select_, XR_ACTION_TYPE_BOOLEAN_INPUT, "select",
             "Right: teleport; left: laser pointer", true),
        make(recenter_, XR_ACTION_TYPE_BOOLEAN_INPUT, "recenter", "Back to the start"),
        make(grip_, XR_ACTION_TYPE_POSE_INPUT, "hand", "Hand", true),
        make(aim_, XR_ACTION_TYPE_POSE_INPUT, "aim", "Where the hand points", true)}) {
    if (!status) return status;
  }
  return {};
}

Status Actions::suggest_bindings(const Runtime& runtime) const {
  bool one_was_taken = false;
  Status fault;
  for (const Controller& controller : kControllers) {
    if (controller.extension != nullptr && !runtime.has(controller.extension)) continue;
    std::vector<XrActionSuggestedBinding> bindings;
    const auto bind = [&](XrAction action, Hand hand, const char* part) {
      if (part == nullptr) return;
      const auto path = path_of(runtime.instance(), std::string(kHands[hand]) + "/input/" + part);
      if (path) bindings.push_back({action, *path});
    };
    for (const Hand hand : {kLeft, kRight}) {
      bind(sticks_[hand], hand, controller.stick);
      bind(press_, hand, controller.press);
      bind(point_, hand, controller.point);
      bind(select_, hand, controller.select);
      bind(grip_, hand, "grip/pose");
      bind(aim_, hand, "aim/pose");
    }
    bind(recenter_, kLeft, controller.recenter);
    const auto profile =
        path_of(runtime.instance(), std::string("/interaction_profiles/") + controller.profile);
    if (!profile) return profile.error();
    auto suggestion = xr_struct<XrInteractionProfileSuggestedBinding>(
        XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING);
    suggestion.interactionProfile = *profile;
    suggestion.suggestedBindings = bindings.data();
    suggestion.countSuggestedBindings = static_cast<std::uint32_t>(bindings.size());
    fault = xr_status(xrSuggestInteractionProfileBindings(runtime.instance(), &suggestion),
                      "naming controllers");
    one_was_taken |= fault.ok();
  }
  return one_was_taken ? Status{} : fault;  // a runtime need not support all controllers
}

Status Actions::attach(XrSession session) {
  auto info = xr_struct<XrSessionActionSetsAttachInfo>(XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO);
  info.countActionSets = 1;
  info.actionSets = &set_;
  ROOMCAST_XR_TRY(xrAttachSessionActionSets(session, &info), "asking for the controllers");
  for (const Hand hand : {kLeft, kRight}) {
    const auto grip = hand_space(session, grip_, hand), aim = hand_space(session, aim_, hand);
    if (grip) grips_[hand] = *grip;
    if (aim) aims_[hand] = *aim;
    if (!grip || !aim) return grip ? aim.error() : grip.error();
  }
  return {};
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
  const auto recenter = button(session, recenter_);
  if (!recenter) return recenter.error();
  const auto left = read_hand(session, stage, time, kLeft),
             right = read_hand(session, stage, time, kRight);
  if (!left || !right) return left ? right.error() : left.error();
  input.left = *left;
  input.right = *right;
  input.recenters |= is_held(*recenter) && recenter->changedSinceLastSync;
  return {};
}

Result<VrHand> Actions::read_hand(XrSession session, XrSpace stage, XrTime time, Hand hand) const {
  const auto pushed = stick(session, sticks_[hand]);
  if (!pushed) return pushed.error();
  const auto press = button(session, press_, hands_[hand]),
             point = button(session, point_, hands_[hand]),
             select = button(session, select_, hands_[hand]);
  for (const auto* one : {&press, &point, &select}) {
    if (!*one) return one->error();
  }
  const auto grip = place_of(grips_[hand], stage, time), aim = place_of(aims_[hand], stage, time);
  if (!grip || !aim) return grip ? aim.error() : grip.error();
  const bool counts = !press->isActive || press->currentState;
  return VrHand{*grip, *aim, counts ? *pushed : Eigen::Vector2d(0, 0), is_held(*point),
                is_held(*select)};
}

Actions::~Actions() {
  for (const XrSpace space : {grips_[kLeft], grips_[kRight], aims_[kLeft], aims_[kRight]}) {
    if (space != XR_NULL_HANDLE) xrDestroySpace(space);
  }
  if (set_ != XR_NULL_HANDLE) xrDestroyActionSet(set_);  // destroys its actions, too
}

Actions::Actions(Actions&& other) noexcept {
  *this = std::move(other);
}

Actions& Actions::operator=(Actions&& other) noexcept {
  std::swap(set_, other.set_);
  std::swap(sticks_, other.sticks_);
  std::swap(press_, other.press_);
  std::swap(point_, other.point_);
  std::swap(select_, other.select_);
  std::swap(recenter_, other.recenter_);
  std::swap(grip_, other.grip_);
  std::swap(aim_, other.aim_);
  std::swap(hands_, other.hands_);
  std::swap(grips_, other.grips_);
  std::swap(aims_, other.aims_);
  return *this;
}

}  // namespace roomcast::viewer::xr
