// SPDX-License-Identifier: Apache-2.0
// Headset: an OpenXR session: its states, frames and controllers. The order of calls is that of
// OpenXR 1.0, sections 9 and 10. Threading: the thread of the GL context that was current at
// open().
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
#include "roomcast/viewer/xr/notice_layer.h"
#include "roomcast/viewer/xr/runtime.h"
#include "roomcast/viewer/xr/vr_walk.h"

namespace roomcast::viewer::xr {

inline constexpr std::size_t kEyes = 2;

struct HeadsetFrame {
  bool is_seen = false;  // false: draw nothing, but end the frame
  VrInput input;
};

class Headset {
 public:
  /// Needs a current GL context. kUnavailable, with advice, if there is no headset.
  static Result<std::unique_ptr<Headset>> open();
  ~Headset();
  Headset(const Headset&) = delete;
  Headset& operator=(const Headset&) = delete;

  /// Handles the runtime's events. kClosed: the session is over (lost, or ended by the user in the
  /// headset's software: has_exited()); then destroy the Headset.
  Status poll();
  /// The user has ended the session. It must not begin again of its own accord (OpenXR 1.0, section
  /// 9.3, XR_SESSION_STATE_EXITING).
  [[nodiscard]] bool has_exited() const { return state_ == XR_SESSION_STATE_EXITING; }
  /// True if the runtime wants frames, seen or not; false while the headset is not worn.
  [[nodiscard]] bool is_running() const { return is_running_; }
  /// True if the displays only add light to what the wearer sees anyway.
  [[nodiscard]] bool adds_light() const {
    return blend_mode_ == XR_ENVIRONMENT_BLEND_MODE_ADDITIVE;
  }
  /// True if the displays can show what is around the wearer where a picture is transparent.
  [[nodiscard]] bool may_see_through() const { return may_see_through_; }
  /// From the next frame on, where the displays can: pictures are premultiplied by their alpha.
  void see_through(bool on) { sees_through_ = on; }
  [[nodiscard]] XrSessionState state() const { return state_; }
  [[nodiscard]] const std::string& name() const { return runtime_.name(); }
  [[nodiscard]] const FrameTiming& timing() const { return timing_; }

  /// Errors as xr_status.
  Result<HeadsetFrame> begin_frame();
  /// Left and right, in the stage's frame.
  [[nodiscard]] render::Eyes stage_eyes() const { return {eyes_[0].camera(), eyes_[1].camera()}; }
  /// Takes the picture drawn for stage_eyes(). end_frame() reports errors.
  void show(const render::OffscreenTarget& picture);
  /// Sentences before the wearer's eyes, until others or none are told. Errors as
  /// NoticeLayer::show.
  Status tell(const std::vector<Toast>& sentences) { return notices_->show(sentences); }
  /// Submits the pictures of both eyes, and what was told. Errors as xr_status.
  Status end_frame();
  /// Requests the end of the session; poll() reports when it has ended.
  Status request_exit();

 private:
  explicit Headset(Runtime runtime, GraphicsBinding binding)
      : runtime_(std::move(runtime)), binding_(std::move(binding)) {}
  Status create_session();
  Status choose_blend_mode();
  Status create_stage();
  Status create_layers();
  Status take(const XrEventDataSessionStateChanged& change);
  Status locate_eyes(VrInput& input);
  void take_space_changes(VrInput& input);
  [[nodiscard]] Result<bool> has_pictures() const;

  SteadyClock clock_;
  Runtime runtime_;
  GraphicsBinding binding_;
  XrSession session_ = XR_NULL_HANDLE;
  XrEnvironmentBlendMode blend_mode_ = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
  bool may_see_through_ = false, sees_through_ = false;
  XrReferenceSpaceType stage_type_ = XR_REFERENCE_SPACE_TYPE_STAGE;
  XrSpace stage_ = XR_NULL_HANDLE;
  std::vector<XrEventDataReferenceSpaceChangePending> space_changes_;  // of the stage, to come
  std::optional<Actions> actions_;
  std::vector<EyeTarget> eyes_;
  std::unique_ptr<NoticeLayer> notices_;
  XrSessionState state_ = XR_SESSION_STATE_UNKNOWN;
  bool is_running_ = false;

  XrFrameState frame_{};
  bool frame_is_seen_ = false;
  HostTime frame_begin_{};
  FrameTiming timing_;
};

}  // namespace roomcast::viewer::xr
