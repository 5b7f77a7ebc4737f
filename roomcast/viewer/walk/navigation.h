// SPDX-License-Identifier: Apache-2.0
// Navigation: turns the input of mouse, keys and gamepad into changes of the view, as the page does
// (web/src/view/navigation.ts). Independent of devices: pixels, keys by meaning, axes -1..1.
#pragma once

#include <cstddef>
#include <set>

#include "roomcast/viewer/walk/view_state.h"

namespace roomcast::viewer {

/// Keys that move the viewer while they are held.
enum class WalkKey {
  kForward,
  kBack,
  kLeft,
  kRight,
  kUp,
  kDown,
  kTurnLeft,
  kTurnRight,
  kLookUp,
  kLookDown,
};

/// The effect of dragging the mouse.
enum class Drag {
  kOrbit,  // turns around the pivot
  kPan,    // shifts the view; the surface at the pivot follows the mouse
  kLook,   // turns the head
};

/// A gamepad's axes, -1..1; right, forward and up are positive. Small values count as a stick at
/// rest.
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
  /// True while keys or sticks are held: the view keeps moving.
  [[nodiscard]] bool is_walking() const;

  void go_to(const ViewState& view) { view_ = view; }
  void hold(WalkKey key, bool down);
  void run(bool fast) { running_ = fast; }
  /// For a window that loses the keyboard focus: key releases will not arrive.
  void release_all();
  void set_sticks(const Sticks& sticks) { sticks_ = sticks; }

  /// The mouse moved by this many pixels (y down) in a picture of this height.
  void drag(Drag kind, double dx_px, double dy_px, double picture_height_px,
            double vertical_fov_rad);
  /// Notches of the wheel; positive moves nearer.
  void zoom(double notches);
  /// Notches of the wheel; positive is faster.
  void change_speed(double notches);

  /// Moves the view for this time. Long pauses (a suspended machine) are shortened.
  void advance(double seconds);

 private:
  ViewState view_;
  std::set<WalkKey> held_;
  bool running_ = false;
  double speed_m_per_s_ = kWalkSpeed_m_per_s;
  Sticks sticks_;
};

}  // namespace roomcast::viewer
