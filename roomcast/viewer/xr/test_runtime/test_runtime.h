// SPDX-License-Identifier: Apache-2.0
// TestRuntime: an OpenXR runtime for tests: a headset that nobody wears. It moves as the test says
// by a clock of its own (90 frames a second, without waiting), keeps what each eye was given, and
// notes whoever breaks the order of calls of OpenXR 1.0, sections 9 to 11. It is a shared library
// that Debian's own loader loads (XR_RUNTIME_JSON); a test that links it speaks to the same one.
// Threading: one thread.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <openxr/openxr.h>

#include "roomcast/core/image.h"

namespace roomcast::viewer::xr {

/// What an eye was given with a frame.
struct GivenEye {
  ColorImage color;    // the part that the layer names; top row first
  Image<float> depth;  // OpenGL's, 0..1; empty: none was given
  XrPosef pose{};
  XrFovf fov{};
  float near_m = 0, far_m = 0;  // of the depth
};

/// What the wearer's hands do; by the names of the client's actions.
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

  /// The one that the loader loads.
  static TestRuntime& instance();
  /// As at first. Between sessions only.
  void reset();

  // What the test says.
  std::function<XrPosef(XrTime)> head_at;  // in the stage
  ScriptedHands hands;
  bool is_connected = true;  // a headset is
  bool offers_depth = true;
  bool is_tracked = true;  // the head is
  void take_off();         // and put away; the session goes on when it is put on again
  void put_on();
  void ask_for_end();
  void lose_session();

  // What came of it.
  std::vector<std::string> violations;
  std::uint64_t frames = 0;  // ended
  std::uint64_t frames_with_layer = 0;
  std::array<GivenEye, 2> given;  // with the last layer
  bool uses_egl = false;          // the client's context, else GLX
  int open_handles = 0;           // spaces, swapchains, action sets

 private:
  TestRuntime();
  void change_state(XrSessionState state);
};

}  // namespace roomcast::viewer::xr
