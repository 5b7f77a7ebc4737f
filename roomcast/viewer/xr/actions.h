// SPDX-License-Identifier: Apache-2.0
// Actions: what hands do in a headset, by meaning instead of by button: walk, turn, point,
// recentre, where the hands are. Bindings are suggested for common controllers; people can change
// them in their headset's software. Source: OpenXR 1.0, section 11.
#pragma once

#include <array>

#include <openxr/openxr.h>

#include "roomcast/core/result.h"
#include "roomcast/viewer/xr/vr_walk.h"

namespace roomcast::viewer::xr {

class Actions {
 public:
  /// Once per session, before its first frame. Errors as xr_status.
  static Result<Actions> create(XrInstance instance, XrSession session);
  ~Actions();
  Actions(Actions&& other) noexcept;
  Actions& operator=(Actions&& other) noexcept;

  /// Sticks, buttons and hands at `time`; the head is not touched. Errors as xr_status.
  Status read(XrSession session, XrSpace stage, XrTime time, VrInput& input) const;

 private:
  enum Hand { kLeft, kRight };
  Actions() = default;
  Status make_actions(XrInstance instance);
  Status suggest_bindings(XrInstance instance) const;
  Status attach(XrSession session);
  Result<XrSpace> hand_space(XrSession session, XrAction action, Hand hand) const;

  XrActionSet set_ = XR_NULL_HANDLE;
  XrAction walk_ = XR_NULL_HANDLE, turn_ = XR_NULL_HANDLE;
  XrAction point_ = XR_NULL_HANDLE, recenter_ = XR_NULL_HANDLE;
  XrAction grip_ = XR_NULL_HANDLE, aim_ = XR_NULL_HANDLE;
  std::array<XrPath, 2> hands_{};
  XrSpace left_grip_ = XR_NULL_HANDLE, right_grip_ = XR_NULL_HANDLE, right_aim_ = XR_NULL_HANDLE;
};

}  // namespace roomcast::viewer::xr
