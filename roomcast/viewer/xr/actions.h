// SPDX-License-Identifier: Apache-2.0
// Actions: a headset's controller input, by meaning instead of by button: walk, turn, point,
// recentre, hand poses. Suggests bindings for common controllers; users can change them in the
// headset's software. Source: OpenXR 1.0, section 11.
#pragma once

#include <array>

#include <openxr/openxr.h>

#include "roomcast/core/result.h"
#include "roomcast/viewer/xr/vr_walk.h"

namespace roomcast::viewer::xr {

class Actions {
 public:
  /// Call it once per session, before the first frame. Errors as xr_status.
  static Result<Actions> create(XrInstance instance, XrSession session);
  ~Actions();
  Actions(Actions&& other) noexcept;
  Actions& operator=(Actions&& other) noexcept;

  /// Reads sticks, buttons and hands at `time`; the head is not changed. Errors as xr_status.
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
