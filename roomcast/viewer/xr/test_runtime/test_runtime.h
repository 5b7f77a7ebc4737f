// SPDX-License-Identifier: Apache-2.0
// TestRuntime: an OpenXR runtime for tests, with a simulated headset. The test scripts the
// headset's motion on a simulated clock (90 frames a second, without waiting). The runtime keeps
// the pictures of each eye and records violations of the call order of OpenXR 1.0, sections 9 to
// 11. It is a shared library loaded by Debian's own loader (XR_RUNTIME_JSON); a test that links it
// uses the same instance. Threading: one thread.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <openxr/openxr.h>

#include "roomcast/core/image.h"

namespace roomcast::viewer::xr {

/// The pictures of one eye in a frame.
struct GivenEye {
  ColorImage color;    // the part named by the layer; top row first
  MaskImage alpha;     // the layer's, 255: opaque; empty if the layer does not use it
  Image<float> depth;  // OpenGL's, 0..1; empty: the client gave none
  XrPosef pose{};
  XrFovf fov{};
  float near_m = 0, far_m = 0;  // of the depth
};

/// A flat picture that floats in space.
struct GivenBoard {
  ColorImage color;  // top row first
  XrPosef pose{};
  XrExtent2Df size{};
  bool goes_with_head = false;
};

/// The state of the wearer's hands, by the names of the client's actions, of those of each hand
/// with " left" or " right". An action without a state is inactive.
struct ScriptedHands {
  std::map<std::string, XrVector2f> sticks;
  std::map<std::string, bool> buttons;
  std::array<bool, 2> is_tracked = {true, true};
  std::array<XrPosef, 2> poses = {XrPosef{{0, 0, 0, 1}, {-0.2F, 1.2F, -0.4F}},
                                  XrPosef{{0, 0, 0, 1}, {0.2F, 1.2F, -0.4F}}};
};

class TestRuntime {
 public:
  static constexpr XrDuration kPeriod_ns = 11'111'111;
  static constexpr XrTime kBegin_ns = 1'000'000'000;
  static constexpr int kEyeWidth = 320, kEyeHeight = 300;
  static constexpr XrFovf kFov[2] = {{-0.80F, 0.70F, 0.75F, -0.72F},
                                     {-0.70F, 0.80F, 0.75F, -0.72F}};
  static constexpr float kHalfEyeDistance_m = 0.0315F;

  /// The instance used by the loader.
  static TestRuntime& instance();
  /// Restores the initial state. Between sessions only.
  void reset();

  // Set by the test.
  std::function<XrPosef(XrTime)> head_at;  // in the stage
  ScriptedHands hands;
  bool service_runs = true;  // else no instance can be created
  bool is_connected = true;  // whether there is a headset
  bool offers_depth = true;
  bool offers_egl = true;
  std::vector<std::string> more_extensions;  // offered, too
  std::vector<XrReferenceSpaceType> spaces = {
      XR_REFERENCE_SPACE_TYPE_VIEW, XR_REFERENCE_SPACE_TYPE_LOCAL, XR_REFERENCE_SPACE_TYPE_STAGE};
  std::vector<XrEnvironmentBlendMode> blend_modes = {XR_ENVIRONMENT_BLEND_MODE_OPAQUE};
  bool is_tracked = true;            // whether the head is tracked
  bool is_seen = true;               // false: another program is in front
  std::deque<XrResult> image_waits;  // results of the next waits for images; then XR_SUCCESS
  float cant_rad = 0;                // each display is turned outwards by this angle, about y
  void take_off();                   // ends rendering; the session resumes at put_on()
  void put_on();
  void ask_for_end();
  void lose_session();
  /// Announces that a space will have moved at this time; `new_in_old`: empty if not known.
  void move_space(XrReferenceSpaceType type, XrTime when, std::optional<XrPosef> new_in_old);

  // Results.
  std::vector<std::string> violations;
  std::uint64_t frames = 0;  // frames ended
  std::uint64_t frames_with_layer = 0;
  std::array<GivenEye, 2> given;          // of the last layer
  std::optional<GivenBoard> given_board;  // of the last frame
  bool uses_egl = false;                  // whether the client's context is EGL's, else GLX's
  XrReferenceSpaceType stage = XR_REFERENCE_SPACE_TYPE_VIEW;  // of the views
  XrEnvironmentBlendMode blend_mode{};                        // of the last frame
  std::set<std::string> extensions;                           // in use
  /// Of each interaction profile, its parts' actions.
  std::map<std::string, std::map<std::string, std::string>> bindings;
  int open_handles = 0;     // spaces, swapchains, action sets
  int acquired_images = 0;  // and not released

 private:
  TestRuntime();
  void change_state(XrSessionState state);
};

}  // namespace roomcast::viewer::xr
