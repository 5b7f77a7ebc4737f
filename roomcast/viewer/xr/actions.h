// SPDX-License-Identifier: Apache-2.0
// Actions: a headset's controller input, by meaning instead of by button: walk, turn, point,
// recentre, hand poses. Suggests bindings for common controllers; users can change them in the
// headset's software. Source: OpenXR 1.0, section 11.
#pragma once

#include <array>

#include <openxr/openxr.h>

#include "roomcast/core/result.h"
#include "roomcast/viewer/xr/runtime.h"
#include "roomcast/viewer/xr/vr_walk.h"

namespace roomcast::viewer::xr {

class Actions {
 public:
  /// Call it once per session, before the first frame. Errors as xr_status.
  static Result<Actions> create(const Runtime& runtime, XrSession session);
  ~Actions();
  Actions(Actions&& other) noexcept;
  Actions& operator=(Actions&& other) noexcept;

  /// Reads sticks, buttons and hands at `time`; the rest is not changed. Errors as xr_status.
  Status read(XrSession session, XrSpace stage, XrTime time, VrInput& input) const;

 private:
  enum Hand { kLeft, kRight };
  Actions() = default;
  Status make_actions(XrInstance instance);
  Status suggest_bindings(const Runtime& runtime) const;
  Status attach(XrSession session);
  Result<XrSpace> hand_space(XrSession session, XrAction action, Hand hand) const;
  Result<VrHand> read_hand(XrSession session, XrSpace stage, XrTime time, Hand hand) const;

  XrActionSet set_ = XR_NULL_HANDLE;
  std::array<XrAction, 2> sticks_{};  // walk and turn: the left one and the right one
  XrAction press_ = XR_NULL_HANDLE, point_ = XR_NULL_HANDLE, select_ = XR_NULL_HANDLE;
  XrAction recenter_ = XR_NULL_HANDLE;
  XrAction grip_ = XR_NULL_HANDLE, aim_ = XR_NULL_HANDLE;
  std::array<XrPath, 2> hands_{};
  std::array<XrSpace, 2> grips_{}, aims_{};
};

}  // namespace roomcast::viewer::xr
