// SPDX-License-Identifier: Apache-2.0
// DesktopInput: SDL's events of mouse, keyboard and gamepad become movement (Navigation) and
// commands. Events that the panel wants for itself are not given to it.
#pragma once

#include <memory>
#include <optional>

#include "roomcast/viewer/walk/navigation.h"
#include "roomcast/viewer/window/viewer_command.h"

union SDL_Event;
struct _SDL_GameController;

namespace roomcast::viewer {

/// What the mouse moves over.
struct PictureUnderMouse {
  double height_units = 720;  // of the desktop, as the mouse's
  double vertical_fov_rad = 1;
};

/// Where the mouse is, in units of the desktop from the top left.
struct MousePlace {
  double x = 0, y = 0;
};

class DesktopInput {
 public:
  DesktopInput();
  ~DesktopInput();
  DesktopInput(DesktopInput&&) noexcept;
  DesktopInput& operator=(DesktopInput&&) noexcept;

  /// Moves `navigation`, or says what is asked for, or neither.
  [[nodiscard]] std::optional<ViewerCommand> take(const SDL_Event& event,
                                                  const PictureUnderMouse& picture,
                                                  Navigation& navigation);

  /// The mouse turns the head, and the wheel sets the speed.
  void set_mouse_look(bool on) { mouse_looks_ = on; }
  [[nodiscard]] bool mouse_looks() const { return mouse_looks_; }
  /// The laser pointer's key or button is held.
  [[nodiscard]] bool is_pointing() const { return key_points_ || pad_points_; }
  [[nodiscard]] const MousePlace& mouse() const { return mouse_; }

 private:
  struct CloseGamepad {
    void operator()(_SDL_GameController* pad) const;
  };

  std::optional<ViewerCommand> take_key(const SDL_Event& event, Navigation& navigation);
  void take_motion(const SDL_Event& event, const PictureUnderMouse& picture,
                   Navigation& navigation);
  std::optional<ViewerCommand> take_pad_button(const SDL_Event& event, Navigation& navigation);
  void take_pad_axis(const SDL_Event& event, Navigation& navigation);

  std::unique_ptr<_SDL_GameController, CloseGamepad> pad_;
  Sticks sticks_;
  double trigger_up_ = 0, trigger_down_ = 0;
  MousePlace mouse_;
  bool mouse_looks_ = false;
  bool key_points_ = false, pad_points_ = false;
};

}  // namespace roomcast::viewer
