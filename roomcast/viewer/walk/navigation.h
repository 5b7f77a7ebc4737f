// SPDX-License-Identifier: Apache-2.0
// Navigation: what a person does with mouse, keys and gamepad becomes changes of the view, as on
// the page (web/src/view/navigation.ts). Knows no devices: pixels, keys by meaning, axes -1..1.
#pragma once

#include <cstddef>
#include <set>

#include "roomcast/viewer/walk/view_state.h"

namespace roomcast::viewer {

enum class WalkKey { kForward, kBack, kLeft, kRight, kUp, kDown };

/// What dragging the mouse does.
enum class Drag {
  kOrbit,  // turns around the pivot
  kPan,    // shifts the view; what lies at the pivot follows the mouse
  kLook,   // turns the head
};

/// Of a gamepad; right, forward and up are positive, -1..1. Small numbers are a stick's rest.
struct Sticks {
  double walk_right = 0, walk_forward = 0, walk_up = 0;
  double look_right = 0, look_up = 0;
};

inline constexpr double kWalkSpeed_m_per_s = 1.4;
inline constexpr double kSlowestWalk_m_per_s = 0.1;
inline constexpr double kFastestWalk_m_per_s = 20;
inline constexpr double kStickRest = 0.15;

class Navigation {
 public:
  explicit Navigation(const ViewState& start) : view_(start) {}

  [[nodiscard]] const ViewState& view() const { return view_; }
  [[nodiscard]] double speed_m_per_s() const { return speed_m_per_s_; }
  /// Keys and sticks are held: it will move on.
  [[nodiscard]] bool is_walking() const;

  void go_to(const ViewState& view) { view_ = view; }
  void hold(WalkKey key, bool down);
  void run(bool fast) { running_ = fast; }
  /// As when the window loses the keyboard: nobody will tell of keys that are released.
  void release_all();
  void set_sticks(const Sticks& sticks) { sticks_ = sticks; }

  /// The mouse moved by so many pixels (y down) over a picture this high.
  void drag(Drag kind, double dx_px, double dy_px, double picture_height_px,
            double vertical_fov_rad);
  /// Notches of the wheel: nearer is positive.
  void zoom(double notches);
  /// Notches: faster is positive.
  void change_speed(double notches);

  /// Goes on walking for so long. Long pauses (a machine that slept) count as short ones.
  void advance(double seconds);

 private:
  ViewState view_;
  std::set<WalkKey> held_;
  bool running_ = false;
  double speed_m_per_s_ = kWalkSpeed_m_per_s;
  Sticks sticks_;
};

}  // namespace roomcast::viewer
