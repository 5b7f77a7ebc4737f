// SPDX-License-Identifier: Apache-2.0
// SessionRecord: TestRuntime's state behind OpenXR's handles.
#pragma once

#include <cstring>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include <epoxy/gl.h>
#include <openxr/openxr.h>

namespace roomcast::viewer::xr {

struct SpaceRecord {
  XrPosef offset{};
  int hand = -1;  // -1: a reference space
  XrReferenceSpaceType type = XR_REFERENCE_SPACE_TYPE_STAGE;
};

struct SwapchainRecord {
  XrSwapchainCreateInfo info{};
  std::vector<GLuint> textures;
  std::uint32_t next = 0;
  int acquired = -1;
  bool waited = false;
  int released = -1;  // the newest released image
};

struct SessionRecord {
  bool asked_for_requirements = false, exists = false, running = false, lost = false;
  bool actions_attached = false;
  bool frame_waited = false, frame_begun = false;
  XrSessionState state = XR_SESSION_STATE_UNKNOWN;
  XrTime display = 0;
  std::deque<XrEventDataBuffer> events;
  std::map<std::string, XrPath> paths;
  std::vector<std::string> path_names = {""};
  std::map<XrAction, std::string> actions;
  std::map<std::string, bool> last_buttons;
};

/// To be polled by the client.
template <class Event>
XrEventDataBuffer packed(const Event& event) {
  XrEventDataBuffer buffer{};
  std::memcpy(&buffer, &event, sizeof event);
  return buffer;
}

/// Whether a controller of this profile has this part; extensions decide whether it is known.
bool has_part(const std::string& profile, const std::string& part);

/// The record of the single client.
SessionRecord& session_record();

/// A handle encodes an address or a number.
template <class Handle, class Value>
Handle handle_from(Value value) {
  return reinterpret_cast<Handle>(value);
}

inline const XrSession kTheSession = handle_from<XrSession>(std::uintptr_t{0x51});
inline const XrInstance kTheInstance = handle_from<XrInstance>(std::uintptr_t{0x11});

/// Records the violation and returns `result`.
XrResult violation(const char* what, XrResult result);

/// The function of this name; null if there is none.
PFN_xrVoidFunction instance_function(const std::string& name);
PFN_xrVoidFunction session_function(const std::string& name);
PFN_xrVoidFunction frame_function(const std::string& name);
PFN_xrVoidFunction input_function(const std::string& name);

/// Implements OpenXR's two-call idiom for arrays.
template <class Item>
XrResult fill(std::uint32_t capacity, std::uint32_t* count, Item* items,
              const std::vector<Item>& values) {
  *count = static_cast<std::uint32_t>(values.size());
  if (capacity == 0) return XR_SUCCESS;
  if (capacity < values.size()) return XR_ERROR_SIZE_INSUFFICIENT;
  for (std::size_t i = 0; i < values.size(); ++i) items[i] = values[i];
  return XR_SUCCESS;
}

template <class Function>
PFN_xrVoidFunction untyped(Function* function) {
  return reinterpret_cast<PFN_xrVoidFunction>(function);
}

}  // namespace roomcast::viewer::xr
