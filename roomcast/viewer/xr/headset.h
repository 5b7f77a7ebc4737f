// SPDX-License-Identifier: Apache-2.0
// Headset: a session with a headset: its coming and going, its frames, its hands. The order of
// calls is that of OpenXR 1.0, sections 9 and 10. Threading: the thread of the GL context that was
// current when it was opened.
//
//   poll() every round; while is_running():
//     begin_frame() - waits until the headset wants a frame - draw stage_eyes() - show() -
//     end_frame()
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <openxr/openxr.h>

#include "roomcast/core/clock.h"
#include "roomcast/render/view/eyes.h"
#include "roomcast/viewer/xr/actions.h"
#include "roomcast/viewer/xr/eye_target.h"
#include "roomcast/viewer/xr/frame_timing.h"
#include "roomcast/viewer/xr/graphics_binding.h"
#include "roomcast/viewer/xr/runtime.h"
#include "roomcast/viewer/xr/vr_walk.h"

namespace roomcast::viewer::xr {

inline constexpr std::size_t kEyes = 2;

struct HeadsetFrame {
  bool is_seen = false;  // else draw nothing, but end the frame
  VrInput input;
};

class Headset {
 public:
  /// Needs a current GL context. kUnavailable, with what to do, when there is no headset.
  static Result<std::unique_ptr<Headset>> open();
  ~Headset();
  Headset(const Headset&) = delete;
  Headset& operator=(const Headset&) = delete;

  /// Takes what the headset's software says. kClosed: it is over (lost, or the person ended it
  /// there); the Headset can only be destroyed then.
  Status poll();
  /// It wants frames. False while nobody wears it.
  [[nodiscard]] bool is_running() const { return is_running_; }
  [[nodiscard]] XrSessionState state() const { return state_; }
  [[nodiscard]] const std::string& name() const { return runtime_.name(); }
  [[nodiscard]] const FrameTiming& timing() const { return timing_; }

  /// Errors as xr_status.
  Result<HeadsetFrame> begin_frame();
  /// Left and right, in the stage's frame.
  [[nodiscard]] render::Eyes stage_eyes() const { return {eyes_[0].camera(), eyes_[1].camera()}; }
  /// What was drawn for stage_eyes(). Whether that went well end_frame() says.
  void show(const render::OffscreenTarget& picture);
  /// Hands over what was shown to both eyes. Errors as xr_status.
  Status end_frame();
  /// Asks for the end of the session; poll() then says when it is over.
  Status request_exit();

 private:
  explicit Headset(Runtime runtime, GraphicsBinding binding)
      : runtime_(std::move(runtime)), binding_(std::move(binding)) {}
  Status create_session();
  Status create_stage();
  Status create_eyes();
  Status take(const XrEventDataSessionStateChanged& change);
  Status locate_eyes(VrInput& input);

  SteadyClock clock_;
  Runtime runtime_;
  GraphicsBinding binding_;
  XrSession session_ = XR_NULL_HANDLE;
  XrSpace stage_ = XR_NULL_HANDLE;
  std::optional<Actions> actions_;
  std::vector<EyeTarget> eyes_;
  XrSessionState state_ = XR_SESSION_STATE_UNKNOWN;
  bool is_running_ = false;

  XrFrameState frame_{};
  bool frame_is_seen_ = false;
  HostTime frame_begin_{};
  FrameTiming timing_;
};

}  // namespace roomcast::viewer::xr
