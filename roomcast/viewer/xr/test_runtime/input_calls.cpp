// SPDX-License-Identifier: Apache-2.0
// TestRuntime: paths, actions and hand poses (OpenXR 1.0, sections 6, 7 and 11).
#include <cstring>

#include "roomcast/viewer/xr/test_runtime/session_record.h"
#include "roomcast/viewer/xr/test_runtime/test_runtime.h"

namespace roomcast::viewer::xr {
namespace {

XRAPI_ATTR XrResult XRAPI_CALL string_to_path(XrInstance, const char* name, XrPath* path) {
  SessionRecord& session = session_record();
  if (name[0] != '/') return violation("a path that is none", XR_ERROR_PATH_FORMAT_INVALID);
  auto [known, is_new] = session.paths.try_emplace(name, session.path_names.size());
  if (is_new) session.path_names.emplace_back(name);
  *path = known->second;
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL path_to_string(XrInstance, XrPath path, std::uint32_t capacity,
                                              std::uint32_t* count, char* out) {
  const auto& names = session_record().path_names;
  if (path == XR_NULL_PATH || path >= names.size()) return XR_ERROR_PATH_INVALID;
  *count = static_cast<std::uint32_t>(names[path].size()) + 1;
  if (capacity >= *count) std::strcpy(out, names[path].c_str());
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL create_action_set(XrInstance, const XrActionSetCreateInfo*,
                                                 XrActionSet* set) {
  ++TestRuntime::instance().open_handles;
  *set = handle_from<XrActionSet>(std::uintptr_t{0xA5});
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL destroy_action_set(XrActionSet) {
  --TestRuntime::instance().open_handles;
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL create_action(XrActionSet, const XrActionCreateInfo* info,
                                             XrAction* action) {
  SessionRecord& session = session_record();
  if (session.actions_attached)
    return violation("an action after all were attached", XR_ERROR_ACTIONSETS_ALREADY_ATTACHED);
  *action = handle_from<XrAction>(std::uintptr_t{0x100} + session.actions.size());
  session.actions[*action] = info->actionName;
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL destroy_action(XrAction) {
  return XR_SUCCESS;
}

/// As a real runtime does, takes all bindings of a profile or none.
XRAPI_ATTR XrResult XRAPI_CALL suggest_bindings(XrInstance,
                                                const XrInteractionProfileSuggestedBinding* info) {
  if (info->countSuggestedBindings == 0 || info->interactionProfile == XR_NULL_PATH)
    return violation("bindings of nothing", XR_ERROR_VALIDATION_FAILURE);
  SessionRecord& session = session_record();
  const std::string profile = session.path_names.at(info->interactionProfile);
  std::map<std::string, std::string> bindings;
  for (std::uint32_t i = 0; i < info->countSuggestedBindings; ++i) {
    const auto& [action, path] = info->suggestedBindings[i];
    const std::string part = session.path_names.at(path);
    if (!has_part(profile, part))
      return violation("a controller's part that there is not", XR_ERROR_PATH_UNSUPPORTED);
    bindings[part] = session.actions.at(action);
  }
  TestRuntime::instance().bindings[profile] = bindings;
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL attach(XrSession, const XrSessionActionSetsAttachInfo*) {
  SessionRecord& session = session_record();
  if (session.actions_attached)
    return violation("actions attached twice", XR_ERROR_ACTIONSETS_ALREADY_ATTACHED);
  session.actions_attached = true;
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL sync(XrSession, const XrActionsSyncInfo*) {
  SessionRecord& session = session_record();
  if (!session.actions_attached)
    return violation("actions read before they were attached", XR_ERROR_ACTIONSET_NOT_ATTACHED);
  return session.state == XR_SESSION_STATE_FOCUSED ? XR_SUCCESS : XR_SESSION_NOT_FOCUSED;
}

std::string hand_of(XrPath path) {
  const std::string& name = session_record().path_names.at(path);
  return name.empty() ? "" : " " + name.substr(name.rfind('/') + 1);
}

XRAPI_ATTR XrResult XRAPI_CALL get_boolean(XrSession, const XrActionStateGetInfo* info,
                                           XrActionStateBoolean* state) {
  SessionRecord& session = session_record();
  const std::string name = session.actions.at(info->action) + hand_of(info->subactionPath);
  const auto& buttons = TestRuntime::instance().hands.buttons;
  const auto scripted = buttons.find(name);
  const bool now = scripted != buttons.end() && scripted->second;
  bool& before = session.last_buttons[name];
  state->currentState = now ? XR_TRUE : XR_FALSE;
  state->changedSinceLastSync = now != before ? XR_TRUE : XR_FALSE;
  state->isActive = scripted != buttons.end() ? XR_TRUE : XR_FALSE;
  state->lastChangeTime = session.display;
  before = now;
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL get_vector(XrSession, const XrActionStateGetInfo* info,
                                          XrActionStateVector2f* state) {
  const std::string name = session_record().actions.at(info->action);
  state->currentState = TestRuntime::instance().hands.sticks[name];
  state->isActive = XR_TRUE;
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL create_action_space(XrSession, const XrActionSpaceCreateInfo* info,
                                                   XrSpace* space) {
  ++TestRuntime::instance().open_handles;
  const auto& hand = session_record().path_names.at(info->subactionPath);
  *space = handle_from<XrSpace>(
      new SpaceRecord{info->poseInActionSpace, hand == "/user/hand/left" ? 0 : 1});
  return XR_SUCCESS;
}

XRAPI_ATTR XrResult XRAPI_CALL locate_space(XrSpace space, XrSpace, XrTime,
                                            XrSpaceLocation* location) {
  const auto& record = *reinterpret_cast<const SpaceRecord*>(space);
  const ScriptedHands& hands = TestRuntime::instance().hands;
  const auto hand = static_cast<std::size_t>(record.hand);
  location->locationFlags = 0;
  if (record.hand < 0 || !hands.is_tracked[hand]) return XR_SUCCESS;
  location->locationFlags =
      XR_SPACE_LOCATION_POSITION_VALID_BIT | XR_SPACE_LOCATION_ORIENTATION_VALID_BIT;
  location->pose = hands.poses[hand];
  return XR_SUCCESS;
}

}  // namespace

PFN_xrVoidFunction input_function(const std::string& name) {
  static const std::map<std::string, PFN_xrVoidFunction> functions = {
      {"xrStringToPath", untyped(string_to_path)},
      {"xrPathToString", untyped(path_to_string)},
      {"xrCreateActionSet", untyped(create_action_set)},
      {"xrDestroyActionSet", untyped(destroy_action_set)},
      {"xrCreateAction", untyped(create_action)},
      {"xrDestroyAction", untyped(destroy_action)},
      {"xrSuggestInteractionProfileBindings", untyped(suggest_bindings)},
      {"xrAttachSessionActionSets", untyped(attach)},
      {"xrSyncActions", untyped(sync)},
      {"xrGetActionStateBoolean", untyped(get_boolean)},
      {"xrGetActionStateVector2f", untyped(get_vector)},
      {"xrCreateActionSpace", untyped(create_action_space)},
      {"xrLocateSpace", untyped(locate_space)}};
  const auto found = functions.find(name);
  return found != functions.end() ? found->second : nullptr;
}

}  // namespace roomcast::viewer::xr
